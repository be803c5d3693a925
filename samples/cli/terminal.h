// What the command prints. Names come from files, and a terminal obeys the control characters in them.
#pragma once

#include <cstdio>

namespace cli
{

// From here on stdout, stderr, std::cout and std::cerr show control characters, and bytes that are no UTF-8, as \x1b.
// Lines and tabs stay. To be called before anything is printed.
void show_control_characters();

// Bytes that are no text, such as pictures; and the command's own control characters.
std::FILE *raw_output();
std::FILE *raw_errors();

}  // namespace cli
