// Checks that a theatre can be built and sat in.
#pragma once

#include "samples/scenes/odeon/theatre.h"

namespace scenes
{

// The seated pose of the built-in characters, in metres at scale 1: the seat's height above the feet, the distance of
// the feet before the seat's edge, and that of the end of the stone under the toes.
constexpr double sitting_height_m = 0.43, seat_edge_to_feet_m = 0.17, seat_edge_to_toes_m = 0.43;

// Throws Failure with the first contradiction and its place in the theatre's file; rows count from 1. `where`: the
// place of the theatre itself.
void validate(const Theatre &theatre, const std::string &where);

}  // namespace scenes
