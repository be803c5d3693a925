// Units of the coordinates in files of trajectories.
#pragma once

#include <string>

namespace scenes
{

// m, cm, mm, ft, or the metres in one. Returns "", or a sentence that says what is wrong.
std::string read_unit(const std::string &unit, double &metres);

}  // namespace scenes
