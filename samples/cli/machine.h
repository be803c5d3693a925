// What figures were measured on.
#pragma once

#include "samples/cli/scene_arguments.h"

namespace cli
{

// {"processor": its maker's words, "cores": how many this process may use}
Json machine();

}  // namespace cli
