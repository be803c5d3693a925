// A floor of coloured marbles cut to shapes (opus sectile), drawn by code: panels of circles and squares within rings.
#pragma once

#include "samples/scenes/texture.h"

namespace scenes
{

// A round floor whose rim touches the picture's edges; the corners beyond are white marble. panels: their number
// across the floor.
Image opus_sectile(uint64_t seed, int panels);

}  // namespace scenes
