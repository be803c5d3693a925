#include "tests/cli/help.h"

#include <sstream>

#include "tests/cli/run.h"

namespace cli_test
{
namespace
{

void add_commands(const std::vector<std::string> &command, std::vector<std::vector<std::string>> &all)
{
    const std::vector<std::string> below = help_of(command).subcommands;
    for (const std::string &name : below) {
        std::vector<std::string> longer = command;
        longer.push_back(name);
        add_commands(longer, all);
    }
    if (below.empty()) all.push_back(command);
}

}  // namespace

Help help_of(std::vector<std::string> command)
{
    command.emplace_back("--help");
    const Outcome outcome = claque(command);
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    std::istringstream lines(outcome.out);
    Help found;
    bool in_subcommands = false;
    for (std::string line; std::getline(lines, line);) {
        if (!line.empty() && line[0] != ' ') in_subcommands = line == "Subcommands:";
        if (line.size() < 3 || line.compare(0, 2, "  ") != 0 || line[2] == ' ') continue;
        const std::string names = line.substr(2, line.find(' ', 2) - 2);  // "-o,--out"
        if (in_subcommands) found.subcommands.push_back(names);
        else found.options.insert(names.substr(names.find_last_of(',') + 1));
    }
    return found;
}

std::vector<std::vector<std::string>> all_commands()
{
    std::vector<std::vector<std::string>> all;
    add_commands({}, all);
    return all;
}

}  // namespace cli_test
