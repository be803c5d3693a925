// A folder of files that are found by a hash of what they were made from.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace claque::asset
{

// A 128-bit hash of everything that is added, in order. It does not resist deliberate collisions.
class ContentHash
{
public:
    ContentHash();
    void add(const void *bytes, uint64_t size);  // hashes the size as well
    void add(const std::string &text) { add(text.data(), text.size()); }
    void add(uint64_t number) { add(&number, sizeof number); }
    void add(double number) { add(&number, sizeof number); }
    std::string hex() const;

private:
    uint64_t a_, b_;
};

// Adds the bytes of a glTF file and of the files that it names below `folder`, or of any other file. A missing file is
// hashed as missing; its reader reports it. Throws base::Error as read_file does.
void add_bytes(const void *bytes, uint64_t size, const std::string &folder, uint64_t limit_bytes,
               ContentHash &content_hash);  // the same for a file that has been read; `folder`: "" for no others
void add_file(const std::string &path, const std::string &folder, uint64_t limit_bytes, ContentHash &content_hash);

// $XDG_CACHE_HOME/claque or ~/.cache/claque; empty if neither variable is set.
std::string user_cache_folder();

// Empty if the file is missing, cannot be read or may have been written by another user.
std::vector<uint8_t> read_cached(const std::string &folder, const std::string &name);

// Writes the whole file or nothing. Returns "" or the reason of the failure.
std::string write_cached(const std::string &folder, const std::string &name, const std::vector<uint8_t> &bytes);

}  // namespace claque::asset
