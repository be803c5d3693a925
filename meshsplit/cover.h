// Finds the texels that a triangle can show: every texel that any point of the closed triangle can sample with
// GL_NEAREST at exactly this texture size, at any distance and sub-pixel offset.
#pragma once

#include <glm/vec2.hpp>

#include "lib/model/model.h"

namespace claque::meshsplit
{

// Rasterisers snap vertices to fractions of a pixel and extrapolate by as much beyond the triangle: 1/512 pixel for the
// usual 8 bits, which is this much where 64 texels fall on a pixel. Triangles are grown by it on all sides, in texels.
constexpr double sampling_slack = 1.0 / 8.0;
// The error of interpolating texture coordinates in float, as a fraction of the largest coordinate.
constexpr double float_slack = 1.0 / 1048576.0;

struct TexelGrid {
    uint32_t width = 0, height = 0;
    model::Wrap wrap_s = model::Wrap::repeat, wrap_t = model::Wrap::repeat;  // repeat or clamp
};

struct UvTriangle {
    glm::vec2 corners[3];
};

struct TexelSpan {
    uint32_t row = 0, first = 0, count = 0;
};

// Appends the texels of the triangle, grown by the slack, as spans inside the grid. A texel may appear more than once.
// Points and lines in UV are treated like other triangles. Triangles over more than 16 heights of the texture get the
// whole texture.
void cover(const TexelGrid &grid, const UvTriangle &triangle, std::vector<TexelSpan> &out);

// Returns the slack of one triangle on this grid, in texels.
double slack_of(const TexelGrid &grid, const UvTriangle &triangle);

}  // namespace claque::meshsplit
