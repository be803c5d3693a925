// The zones that a triangle may show: those of all texels that it touches.
#pragma once

#include "samples/parity/write/texels.h"

namespace parity
{

// Triangles in the order of drawing, three indices each.
struct ZoneTriangles {
    uint32_t zone = 0;
    std::vector<uint32_t> indices;
};

// Finds for each zone, ascending, those of the triangles that may show it. A triangle that touches several zones is
// found for each of them. A margin of a hundredth of a texel allows for the rounding of a renderer's coordinates.
//   uvs   two numbers a vertex
std::vector<ZoneTriangles> zone_cover(const clq_triangles &triangles, const float *uvs, const Texels &texels);

}  // namespace parity
