// The machine that measurements were made on.
#pragma once

#include "samples/cli/scene_arguments.h"

namespace cli
{

// {"processor": its maker's name, "cores": how many this process may use}
Json machine();

}  // namespace cli
