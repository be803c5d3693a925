// The one reader of TOML's numbers in libclaque-stage.
#pragma once

#include <string>
#include <string_view>

#include "lib/stage/machine/toml.h"

namespace claque::stage
{

// The number as the file has it. toml++ gives an empty optional for a number that no double holds. `wrong` is "", or
// the reason for a refusal, as in "is not finite"; the result is then infinite or NaN.
double number_in(const toml::node &node, std::string &wrong);

// Whether a number of an expression, which was read as `value`, has digits alone and not those of `value`.
bool is_rounded(std::string_view number, double value);

}  // namespace claque::stage
