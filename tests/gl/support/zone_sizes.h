// Textures of zones in other sizes, after what meshsplit/pyramid.h says of them.
#pragma once

#include "tests/gl/support/source_zones.h"

namespace gltest
{

// Texels that nothing shows take the nearest one that is shown; the lower column first, then the lower row.
void fill_unseen(ZoneTexels &texels, const std::vector<uint8_t> &seen);

// Each texel gets the zone of the largest area in it; of equal ones, that of the largest area in a box that is larger
// by a texel on each side, then the lower one.
void resize(ZoneTexels &texels, uint32_t width, uint32_t height);

// The side of a texture for an image of this side.
uint32_t fitted(uint32_t side, uint32_t most_px);
bool is_power_of_two(uint32_t side);

}  // namespace gltest
