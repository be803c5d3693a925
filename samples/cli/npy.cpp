#include "samples/cli/npy.h"

#include <cstring>

namespace cli
{

std::string npy(const std::vector<float> &values, size_t columns)
{
    constexpr size_t before_text = 10, alignment = 64;  // magic, version and length; the values start at a multiple
    std::string text = "{'descr': '<f4', 'fortran_order': False, 'shape': (" + std::to_string(values.size() / columns) +
                       ", " + std::to_string(columns) + "), }";
    text.append(alignment - (before_text + text.size() + 1) % alignment, ' ');
    text += '\n';
    std::string file("\x93NUMPY\x01\x00", 8);
    file += static_cast<char>(text.size() & 255);
    file += static_cast<char>(text.size() >> 8);
    file += text;
    for (const float value : values) {
        uint32_t bits = 0;
        std::memcpy(&bits, &value, sizeof bits);
        for (int shift = 0; shift < 32; shift += 8) file += static_cast<char>(bits >> shift & 255);
    }
    return file;
}

}  // namespace cli
