// The stone that the audience sits on: rows of seats in blocks, stairs in the gangways, walkways, the podium and the
// wall round it all. Swept round the upright axis in the theatre's coordinates.
#pragma once

#include "samples/scenes/geometry.h"
#include "samples/scenes/odeon/theatre.h"

namespace scenes
{

void build_cavea(Geometry &stone, const Theatre &theatre, uint64_t seed);

}  // namespace scenes
