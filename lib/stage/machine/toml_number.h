// The one reader of TOML's numbers in libclaque-stage.
#pragma once

#include <string>
#include <string_view>

#include "lib/stage/machine/toml.h"

namespace claque::stage
{

// The number as the file has it; toml++ itself gives an empty optional for what a double cannot hold. `wrong`: "", or
// why it is none, as in "is not finite"; what is returned then is infinite or NaN.
double number_in(const toml::node &node, std::string &wrong);

// Whether a number of an expression, which was read as `value`, has digits alone and not those of `value`.
bool is_rounded(std::string_view number, double value);

}  // namespace claque::stage
