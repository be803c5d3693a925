// What every file of a subcommand includes: the list of all, and the parser.
#pragma once

#include <CLI/CLI.hpp>

#include "samples/cli/subcommands.h"
