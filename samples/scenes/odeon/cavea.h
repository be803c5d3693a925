// The stone under the audience: rows of seats in blocks, stairs in the gangways, walkways, the podium and the outer
// wall. It is swept round the vertical axis in the theatre's coordinates.
#pragma once

#include "samples/scenes/odeon/theatre.h"
#include "samples/scenes/parts.h"

namespace scenes
{

void build_cavea(Parts &stone, const Theatre &theatre, uint64_t seed);

}  // namespace scenes
