// Painting in three dimensions: every texel that a chart covers knows where on the figure it lies; painters answer with
// luminance and zone, and the gutters take both from the nearest covered texel.
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
    float ambient_visibility = 1;  // 1: sees the whole sky round its normal, 0: nothing
};

struct Paint {
    float luminance = 230;  // 0 .. 255
    Zone zone = Zone::skin;
};

using Painter = std::function<Paint(const Texel &)>;

// How much of its surroundings each texel sees, for soft shadows between limbs and under cloth.
using AmbientVisibility = std::function<float(glm::vec3 position, glm::vec3 normal)>;

// One image for each painter. `mesh` is unwrapped. Deterministic; no texel is left without a key.
std::vector<model::Image> paint(const Mesh &mesh, const AmbientVisibility &ambient_visibility,
                                const std::vector<Painter> &painters, const Zones &zones);

}  // namespace claque::figures
