#include "samples/io/npy.h"

namespace io
{

std::string npy(const std::string &type, const std::vector<size_t> &shape, const void *bytes, size_t size_bytes)
{
    constexpr size_t before_text = 10, alignment = 64;  // magic, version and length; the values start at a multiple
    std::string sides;
    for (const size_t side : shape) sides += (sides.empty() ? "" : ", ") + std::to_string(side);
    if (shape.size() == 1) sides += ",";
    std::string text = "{'descr': '" + type + "', 'fortran_order': False, 'shape': (" + sides + "), }";
    text.append(alignment - (before_text + text.size() + 1) % alignment, ' ');
    text += '\n';
    std::string file("\x93NUMPY\x01\x00", 8);
    file += static_cast<char>(text.size() & 255);
    file += static_cast<char>(text.size() >> 8);
    file += text;
    return size_bytes == 0 ? file : file.append(static_cast<const char *>(bytes), size_bytes);
}

}  // namespace io
