// The stage and the scaenae frons behind it: boards, doors, and two storeys of columns before a wall.
#pragma once

#include "samples/scenes/geometry.h"
#include "samples/scenes/odeon/theatre.h"

namespace scenes
{

void build_stage(Geometry &stone, const Theatre &theatre);

}  // namespace scenes
