// NumPy's array files, version 1.0.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace io
{

// type: as "<f4". The bytes are those of the machine, which is little-endian, in C order.
std::string npy(const std::string &type, const std::vector<size_t> &shape, const void *bytes, size_t size_bytes);

template <class Value>
std::string npy(const std::string &type, const std::vector<size_t> &shape, const std::vector<Value> &values)
{
    return npy(type, shape, values.data(), sizeof(Value) * values.size());
}

}  // namespace io
