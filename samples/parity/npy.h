// Reads NumPy's array files. Files that are not arrays, or not of the wanted type, are rejected with a message.
#pragma once

#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

namespace parity
{

// A capture that cannot be compared: one sentence for the user, with the file's name.
struct Unreadable : std::runtime_error {
    using std::runtime_error::runtime_error;
};

struct Array {
    std::string type;  // as NumPy writes it: "<f4", "|u1" ...
    std::vector<size_t> shape;
    std::vector<unsigned char> bytes;  // C order, little-endian: the product of shape times the type's size

    // For the type that the array has: float for <f4, uint8_t for |u1, uint16_t for <u2, uint32_t for <u4.
    template <class Value>
    std::vector<Value> as() const;
};

// file: the whole file's bytes; name: its name in error messages. type: the required type.
Array read_npy(const std::vector<unsigned char> &file, const std::string &name, const std::string &type);

}  // namespace parity
