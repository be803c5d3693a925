// A clip that an option names.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace cli
{

// The index of a clip by its name, or else by its number. `of`: the character's file. Throws Failure with the names
// that are near.
uint32_t clip_named(const std::string &name, const std::vector<std::string> &clips, const std::string &of);

}  // namespace cli
