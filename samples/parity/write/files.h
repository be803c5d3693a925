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

// A folder of files that is made beside its place and takes it when it is complete. A folder that is there already,
// with an older capture, stays until then; files in it that are no capture's stay for good. All functions throw
// scenes::Failure with the path. Without complete(), or by a signal, nothing is left.
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

private:
    std::string path_, draft_;
    std::vector<std::unique_ptr<io::Unfinished>> unfinished_;  // the folder and its files
};

}  // namespace parity
