// The files of a parity folder (docs/parity.md): arrays as NumPy has them, and whatever bytes.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace parity
{

using Shape = std::vector<size_t>;

// A folder that files are written into; made where there is none. Throws scenes::Failure with the path, as all here do.
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

    // So that nobody reads the rest of an older capture as part of this one.
    void clear() const;

private:
    std::string path_;
};

}  // namespace parity
