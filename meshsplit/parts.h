// The parts of a level that are drawn or left out by themselves, and where each can be in a pose: S0 4.1 Internal
// Bspheres, 4.2 phase 3.
#pragma once

#include "lib/model/template.h"
#include "meshsplit/mesh.h"

namespace claque::meshsplit
{

// Renumbers MeshTriangle::part from parts of the model to parts of the level: those that have triangles, in their order;
// where they are more than model::max_level_parts, neighbours become one, spread evenly. Returns their number.
uint32_t number_parts(Mesh &mesh);

// Fills parts and part_spheres. Parts are numbered.
void make_parts(const Mesh &mesh, uint32_t part_count, const model::Rig &rig, model::Level &out);

}  // namespace claque::meshsplit
