// The parts of a level, which are culled separately, and their bounds in a pose: S0 4.1 Internal Bspheres, 4.2 phase 3.
#pragma once

#include "lib/model/template.h"
#include "meshsplit/mesh.h"

namespace claque::meshsplit
{

// Renumbers MeshTriangle::part from parts of the model to parts of the level: those that have triangles, in order. If
// there are more than model::max_level_parts, neighbours are merged evenly. Returns their number.
uint32_t number_parts(Mesh &mesh);

// Fills parts and part_spheres. Requires number_parts().
void make_parts(const Mesh &mesh, uint32_t part_count, const model::Rig &rig, model::Level &out);

}  // namespace claque::meshsplit
