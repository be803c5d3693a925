// Paints a figure's texture in three dimensions. Every texel that a chart covers has a position on the figure, from
// which a painter computes luminance and zone. Gutters take both from the nearest covered texel.
#pragma once

#include <functional>

#include "lib/figures/mesh.h"

namespace claque::figures
{

struct Texel {
    glm::vec3 position;  // rest pose
    glm::vec3 normal;    // smooth
    Chart chart = Chart::head;
    Region region = Region::torso;
    Side side = Side::left;
    glm::vec2 st;                  // in the chart's own units
    float ambient_visibility = 1;  // 1: the whole hemisphere about its normal is open, 0: nothing of it
};

struct Paint {
    float luminance = 230;  // 0 .. 255
    Zone zone = Zone::skin;
};

using Painter = std::function<Paint(const Texel &)>;

// The open share of each texel's hemisphere, for soft shadows between limbs and under cloth.
using AmbientVisibility = std::function<float(glm::vec3 position, glm::vec3 normal)>;

// Paints one image per painter. `mesh` must be unwrapped. Deterministic; every texel gets a zone key.
std::vector<model::Image> paint(const Mesh &mesh, const AmbientVisibility &ambient_visibility,
                                const std::vector<Painter> &painters, const Zones &zones);

}  // namespace claque::figures
