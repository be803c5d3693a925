// What the command says of itself: its subcommands, and the options of each.
#pragma once

#include <set>
#include <string>
#include <vector>

namespace cli_test
{

struct Help {
    std::vector<std::string> subcommands;
    std::set<std::string> options;  // "--out"; those without dashes are named as they are: "FILE"
};

Help help_of(std::vector<std::string> command);
// Every command that does something, as its words: {"render"}, {"parity", "compare"}.
std::vector<std::vector<std::string>> all_commands();

}  // namespace cli_test
