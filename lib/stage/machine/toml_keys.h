// Guards the TOML parser, which limits nested values but neither the parts of a dotted key nor, with them, the depth of
// the tables that it makes and frees by recursion.
#pragma once

#include <cstdint>
#include <string_view>

namespace claque::stage
{

constexpr uint32_t max_key_parts = 16;

// The number of the first line that has a key, a.b.c, of more than max_key_parts parts; 0: there is none. It need not
// detect wrong syntax.
uint32_t line_of_deep_key(std::string_view text);

}  // namespace claque::stage
