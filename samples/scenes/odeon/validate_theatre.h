// Whether a theatre can be built and sat in.
#pragma once

#include "samples/scenes/odeon/theatre.h"

namespace scenes
{

// How the figures sit, in metres of a person of scale 1: this far above their feet, their feet this far before the edge
// of the seat, and stone for their toes this far before it.
constexpr double sitting_height_m = 0.43, seat_edge_to_feet_m = 0.14, seat_edge_to_toes_m = 0.40;

// Throws Failure with the first thing that makes no sense; rows count from 1.
void validate(const Theatre &theatre, const std::string &where);

}  // namespace scenes
