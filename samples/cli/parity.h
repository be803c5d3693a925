// The subcommands of claque parity.
=======
// The parts of claque parity, one file each.
>>>>>>> 1b6b519 (wip)
#pragma once

#include "samples/cli/command.h"

namespace cli
{

<<<<<<< HEAD
void add_parity_export(CLI::App &parity, Work &chosen);
void add_parity_capture(CLI::App &parity, Work &chosen);

}  // namespace cli
