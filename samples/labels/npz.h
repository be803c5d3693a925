// NumPy's files: single arrays, and archives of several.
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace labels
{

// An array file, version 1.0. type: as "<f4"; the bytes are those of the machine, which is little-endian.
std::string npy(const std::string &type, const std::vector<size_t> &shape, const void *bytes, size_t size_bytes);

template <class Value>
std::string npy(const std::string &type, const std::vector<size_t> &shape, const std::vector<Value> &values)
{
    return npy(type, shape, values.data(), sizeof(Value) * values.size());
}

// An archive as numpy.savez writes it: a ZIP file without compression. The same arrays give the same bytes.
std::string npz(const std::vector<std::pair<std::string, std::string>> &arrays);  // name, array file

}  // namespace labels
