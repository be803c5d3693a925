// Warnings of the library on stderr: each once, whichever of a command's processes comes to it first.
#pragma once

#include <string>

namespace cli
{

// To be called before other processes are forked. Throws std::runtime_error.
void print_warnings();
// From here on this process and those that it forks print none.
void silence_warnings();

// Prints "claque: warning: " and the sentence, unless it was printed.
void print_warning(const std::string &sentence);

}  // namespace cli
