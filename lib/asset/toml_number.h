// The one reader of TOML's numbers in libclaque-assets.
#pragma once

#include <string>

#include "lib/asset/toml.h"

namespace claque::asset
{

// The number as the file has it. toml++ gives an empty optional for a number that no double holds. `wrong` is "", or
// the reason for a refusal, as in "is not finite"; the result is then infinite or NaN.
double number_in(const toml::node &node, std::string &wrong);

}  // namespace claque::asset
