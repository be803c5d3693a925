// A surface of triangles laid flat in an image, in charts that do not overlap: neighbours that face alike lie side by side
// as they do on the surface. Between the files of this room only.
#pragma once

#include <glm/vec2.hpp>

#include "lib/lod/surface_samples.h"

namespace claque::lod
{

constexpr uint32_t atlas_gutter = 2;  // texels round each chart that are no other's

struct Chart {
    std::vector<uint32_t> triangles;
    uint32_t x = 0, y = 0, width = 0, height = 0;  // texels, gutters included
};

struct Atlas {
    uint32_t width = 0, height = 0;                       // texels, powers of two
    double texel_size = 0;                                // its size on the surface, where that lies flat
    std::vector<Chart> charts;                            // each triangle is in one
    std::vector<std::array<glm::dvec2, 3>> texel_coords;  // [triangles] of their corners, in texels
};

// Of `texels` for each triangle, gutters included, rounded up to powers of two; twice as many where that leaves some chart no
// room. Vertices that triangles share join them. Deterministic.
Atlas build_atlas(const PosedParts &level, uint32_t texels);

}  // namespace claque::lod
