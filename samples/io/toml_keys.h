// Guards the TOML parser. It limits nested values but not the parts of a dotted key, and makes and frees the tables of
// these parts by recursion. Some letters outside of strings, as U+00DF, reach code that it takes for unreachable.
#pragma once

#include <cstdint>
#include <string_view>

namespace io
{

constexpr uint32_t max_key_parts = 16;

// The number of the first line that has a key, a.b.c, of more than max_key_parts parts; 0: there is none. It need not
// detect wrong syntax.
uint32_t line_of_deep_key(std::string_view text);

// The number of the first line that has a letter outside of ASCII, which TOML allows in strings and comments alone; 0:
// there is none. A byte order mark at the start is none.
uint32_t line_of_stray_letter(std::string_view text);

// Ten for each of the people that a scenario may have. More take seconds to read.
constexpr uint32_t max_tables = 100000;

// The number of the line with the first table, [a], [[a]] or { }, beyond max_tables; 0: there is none.
uint32_t line_of_table_too_many(std::string_view text);

}  // namespace io
