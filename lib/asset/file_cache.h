// A folder of files that are found by a fingerprint of what they were made from.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace claque::asset
{

// 128 bits of everything that is added, in order. Not against somebody who looks for collisions.
class ContentHash
{
public:
    ContentHash();
    void add(const void *bytes, uint64_t size);  // and how many they are
    void add(const std::string &text) { add(text.data(), text.size()); }
    void add(uint64_t number) { add(&number, sizeof number); }
    void add(double number) { add(&number, sizeof number); }
    std::string hex() const;

private:
    uint64_t a_, b_;
};

// A glTF file's bytes and those of the files that it names, below `folder`; any other file's bytes. A file that is not
// there counts as such: that it is missing is for the reader to say. Throws base::Error as read_file does.
void add_file(const std::string &path, const std::string &folder, uint64_t limit_bytes, ContentHash &content_hash);

// $XDG_CACHE_HOME/claque or ~/.cache/claque; empty where neither is known.
std::string user_cache_folder();

// Empty where there is none or it cannot be read.
std::vector<uint8_t> read_cached(const std::string &folder, const std::string &name);

// Whole or not at all. Returns "" or why not.
std::string write_cached(const std::string &folder, const std::string &name, const std::vector<uint8_t> &bytes);

}  // namespace claque::asset
