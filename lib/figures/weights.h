// Which bones a point follows: at each joint of its region's chain the bones are blended over a stretch that suits the
// joint, then everything is smoothed along the surface, so that cloth and shoulder do not tear.
#pragma once

#include "lib/figures/mesh.h"
#include "lib/figures/skeleton.h"

namespace claque::figures
{

struct Binding {
    std::array<uint32_t, 4> bones{};
    std::array<float, 4> weights{};
};

// One a point of the mesh, at most four bones each, weights falling and summing to 1.
std::vector<Binding> bind(const Mesh &mesh);

}  // namespace claque::figures
