// NumPy's file format, version 1.0, for tables of float32.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace cli
{

// values: rows of `columns` numbers, one row after another.
std::string npy(const std::vector<float> &values, size_t columns);

}  // namespace cli
