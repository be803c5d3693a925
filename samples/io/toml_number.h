// The one reader of TOML's numbers in samples.
#pragma once

#include <string>

#include "samples/io/toml.h"

namespace io
{

// The number as the file has it; toml++ itself gives an empty optional for what a double cannot hold. `wrong`: "", or
// why it is none, as in "is not finite"; what is returned then is infinite or NaN.
double number_in(const toml::node &node, std::string &wrong);

}  // namespace io
