// The files of a parity folder (docs/parity.md): arrays in NumPy's format, and raw bytes.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace parity
{

using Shape = std::vector<size_t>;

// A folder for files, created if missing. All functions throw scenes::Failure with the path.
class Folder
{
public:
    explicit Folder(const std::string &path);

    void write(const std::string &name, const void *bytes, size_t size_bytes) const;
    // The product of `shape` is the number of values.
    void array(const std::string &name, const std::vector<float> &values, const Shape &shape) const;
    void array(const std::string &name, const std::vector<uint32_t> &values, const Shape &shape) const;
    void array(const std::string &name, const std::vector<uint16_t> &values, const Shape &shape) const;
    void array(const std::string &name, const std::vector<uint8_t> &values, const Shape &shape) const;

    // Removes the files of an older capture, so that they cannot be read as part of this one.
    void clear() const;

private:
    std::string path_;
};

}  // namespace parity
