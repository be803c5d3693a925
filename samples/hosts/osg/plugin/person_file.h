// A description of people, such as citizen.claque (docs/hosts.md): a TOML file with a character, its colours and gait.
#pragma once

#include <optional>
#include <string>

#include "samples/scenes/social_classes.h"

namespace osg_plugin
{

enum class Gait { walk, run };

struct PersonFile {
    scenes::SocialClass looks;  // the character, its palette and clips
    Gait gait = Gait::walk;
    std::string colours, colours_at;  // a colour map as a file, and where the description names it; empty: none
    std::string colour_class;         // of that map; empty: the one for the character's template
};

// None if the file describes something else: it names no character. Throws scenes::Failure with line, column and rule.
std::optional<PersonFile> read_person(const std::string &path);

}  // namespace osg_plugin
