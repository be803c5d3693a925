// The dictionary at the head of an array file.
#pragma once

#include <string>
#include <vector>

namespace parity
{

struct NpyHeader {
    std::string type;
    bool fortran_order = false;
    std::vector<size_t> shape;
};

// text: a Python dictionary with the keys 'descr', 'fortran_order' and 'shape'. name: the file's. Throws Unreadable.
NpyHeader npy_header(const std::string &text, const std::string &name);

}  // namespace parity
