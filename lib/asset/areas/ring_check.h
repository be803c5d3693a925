// Whether rings make a polygon: triangles would fill crossing rings, too, and lie upon each other.
#pragma once

#include <string>

#include "lib/asset/areas/area.h"

namespace claque::asset
{

// What is wrong with rings, the first of which is the outside: "" or the end of a sentence about a polygon. Rings may
// touch.
std::string fault_of(const std::vector<Ring> &rings);

}  // namespace claque::asset
