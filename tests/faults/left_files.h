// What a command leaves: its files and its last line.
#pragma once

#include <filesystem>
#include <map>
#include <string>

namespace command_faults
{

// What lies below a folder: each file with its contents; "/" for a folder.
using Files = std::map<std::string, std::string>;
Files files_below(const std::filesystem::path &folder);

// Two files of times are alike if both are whole.
std::string without_times(const std::string &name, const std::string &text);

// "" where the text does not end with a line.
std::string last_line(const std::string &text);

}  // namespace command_faults
