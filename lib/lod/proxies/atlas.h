// Flattens a triangle surface into an image, as charts that do not overlap. Neighbours with similar normals share a
// chart and stay adjacent in it. Internal to lib/lod/proxies.
#pragma once

#include <glm/vec2.hpp>

#include "lib/lod/surface/surface_samples.h"

namespace claque::lod
{

constexpr uint32_t atlas_gutter = 2;  // texels round each chart that no other chart uses

struct Chart {
    std::vector<uint32_t> triangles;
    uint32_t x = 0, y = 0, width = 0, height = 0;  // texels, gutters included
};

struct Atlas {
    uint32_t width = 0, height = 0;  // in texels; powers of two
    double texel_size = 0;           // the size of a texel on the surface, where the chart is not distorted
    std::vector<Chart> charts;       // each triangle is in exactly one chart
    std::vector<std::array<glm::dvec2, 3>> texel_coords;  // [triangles] in texels, per corner
};

// Builds an atlas of about `texels` texels per triangle, gutters included, rounded up to powers of two. It doubles in
// size if some chart does not fit. Triangles are neighbours if they share vertices. Deterministic.
Atlas build_atlas(const PosedParts &level, uint32_t texels);

}  // namespace claque::lod
