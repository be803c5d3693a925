// The files of a parity folder (docs/parity.md): arrays in NumPy's format, and raw bytes.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "samples/io/unfinished.h"

namespace parity
{

using Shape = std::vector<size_t>;

// A folder for files, created if missing. All functions throw scenes::Failure with the path. Files that were written
// are removed by a signal, and with this object, unless complete() was called.
class Folder
{
public:
    explicit Folder(const std::string &path);
    ~Folder();
    Folder(const Folder &) = delete;
    Folder &operator=(const Folder &) = delete;

    void complete();
    void write(const std::string &name, const void *bytes, size_t size_bytes);
    // The product of `shape` is the number of values.
    void array(const std::string &name, const std::vector<float> &values, const Shape &shape);
    void array(const std::string &name, const std::vector<uint32_t> &values, const Shape &shape);
    void array(const std::string &name, const std::vector<uint16_t> &values, const Shape &shape);
    void array(const std::string &name, const std::vector<uint8_t> &values, const Shape &shape);

    // Removes the files of an older capture, so that they cannot be read as part of this one.
    void clear() const;

private:
    std::string path_;
    bool made_ = false;  // by this object
    std::vector<std::string> written_;
    std::vector<std::unique_ptr<io::Unfinished>> unfinished_;
};

}  // namespace parity
