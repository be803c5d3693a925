// toml++ without exceptions (a program may contain only one of its two forms) and without its assertions: damaged files
// break some of them, which would end the process, and with NDEBUG Clang's optimiser takes them for true.
#pragma once

#define TOML_EXCEPTIONS 0
#define TOML_FLOAT_CHARCONV 1  // streams take an allocation that fails for a number that cannot be read
#define TOML_ASSERT(expr) static_assert(true)
#pragma push_macro("NDEBUG")
#undef NDEBUG
#include <toml++/toml.h>
#pragma pop_macro("NDEBUG")
