// The subcommands of claque whose file operations fail, or meet a signal, and what they read.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace command_faults
{

// "<name" stands for a file that is read, ">name" for one that is written; a name that ends in '/' for a folder.
struct Subcommand {
    const char *name;
    std::vector<std::string> words;
    bool draws = false;     // needs a GL
    bool is_slow = false;   // takes seconds, and shares its files' code with quicker ones
    bool recovers = false;  // a library below it does without some operations, with the same result
    bool goes_on = false;   // its folder gets one whole file after the other, and the next run makes what is missing
    bool is_for_signals = false;  // only signals arrive at its operations, and nothing is in the place of its files
};

const std::vector<Subcommand> &subcommands();

// Writes into `folder` what the subcommands read and the command itself does not write.
void make_inputs(const std::filesystem::path &folder);

}  // namespace command_faults
