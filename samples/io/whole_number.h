// Whole numbers in decimal digits, as options and texts of files have them.
#pragma once

#include <charconv>
#include <cstdint>
#include <string>

namespace io
{

constexpr const char *whole_number_rule = "a whole number from 0 to 18446744073709551615, in digits";

// False: the text is not of digits alone, or the number has more than 64 bits.
inline bool read_whole_number(const std::string &text, uint64_t &out)
{
    const char *end = text.data() + text.size();
    const auto [stop, error] = std::from_chars(text.data(), end, out);
    return error == std::errc() && stop == end;
}

}  // namespace io
