// Archives of NumPy's arrays.
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace labels
{

// As numpy.savez writes it: a ZIP file without compression. The same arrays give the same bytes. Throws
// scenes::Failure.
std::string npz(const std::vector<std::pair<std::string, std::string>> &arrays);  // name, array file (io/npy.h)

}  // namespace labels
