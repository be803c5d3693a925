// What every program of subcommands does: it parses, runs the chosen one and turns failures into exit codes: 0 success;
// 1 failure, with one sentence on stderr; 2 wrong usage.
#pragma once

#include <initializer_list>

#include "samples/cli/subcommands.h"

namespace cli
{

using Add = void (*)(CLI::App &app, Work &chosen);

int run_program(int argc, char **argv, std::initializer_list<Add> subcommands);

}  // namespace cli
