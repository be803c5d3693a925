// The options by which commands read the file of a character: --hide, --turn, --height, --scale, --blend.
#pragma once

#include <string>

#include <CLI/CLI.hpp>

#include "samples/scenes/social_classes.h"

namespace cli
{

struct FileArguments {
    scenes::Placement placement;
};

// All of them. A command that has a --scale of its own keeps it, and calls this afterwards.
void add_file_options(CLI::App &command, FileArguments &arguments);
void add_hide_option(CLI::App &command, scenes::Placement &placement);
// All but --hide.
void add_placement_options(CLI::App &command, scenes::Placement &placement);

// Throws Failure where they are given and none of these characters is a file.
void expect_files(const std::vector<scenes::SocialClass> &characters, const scenes::Placement &placement);

// Throws Failure where they are given for what is not read from a file of a character.
void expect_unplaced(const FileArguments &arguments, const std::string &why);

}  // namespace cli
