// Pictures of the amphitheatre's stone and sand, and of a bay of its front, drawn by code.
#pragma once

#include "samples/scenes/texture.h"

namespace scenes::amphitheatre
{

// Weathered travertine: brightness, to be multiplied with a colour. Repeats.
Image travertine(uint64_t seed);

// Raked sand with the marks of many feet: brightness. Repeats.
Image sand(uint64_t seed);

// One bay of the outer wall from the ground (v = 0) to its top: three storeys of arches between half columns, Tuscan,
// Ionic and Corinthian, and an attic with a window in every other bay (two bays: u = 0 to 1/2 and 1/2 to 1). Repeats in
// u.
Image front(uint64_t seed);

}  // namespace scenes::amphitheatre
