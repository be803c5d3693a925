// The subcommands of claque parity, in one or two files each.
#pragma once

#include "samples/cli/command.h"

namespace cli
{

void add_parity_export(CLI::App &parity, Work &chosen);
void add_parity_capture(CLI::App &parity, Work &chosen);
void add_parity_compare(CLI::App &parity, Work &chosen);

}  // namespace cli
