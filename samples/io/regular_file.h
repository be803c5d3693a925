// A file whose name comes from a user or from another file. Only regular files are read: a name may lead to a pipe
// without a writer, a device without an end, or a folder, and reading neither waits nor goes on for ever.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

namespace io
{

// What docs/guide.md states. Texts are TOML, JSON and passwords; a record is mapped, and parts of it are read.
constexpr uint64_t most_text_bytes = uint64_t(64) << 20;
constexpr uint64_t most_file_bytes = uint64_t(4) << 30;
constexpr uint64_t most_record_bytes = uint64_t(1) << 40;

class RegularFile
{
public:
    RegularFile(const std::string &path, uint64_t most_bytes);
    ~RegularFile();
    RegularFile(const RegularFile &) = delete;
    RegularFile &operator=(const RegularFile &) = delete;

    // "", or a sentence with the path and the reason: it cannot be opened, is not regular, or has too many bytes.
    const std::string &wrong() const { return wrong_; }
    int number() const { return number_; }
    uint64_t size() const { return size_; }
    // Whether these bytes are there.
    bool read(uint64_t at, void *bytes, size_t size) const;

private:
    int number_;
    uint64_t size_ = 0;
    std::string wrong_;
};

}  // namespace io
