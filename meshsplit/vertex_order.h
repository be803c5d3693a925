// Orders the vertices of a mesh so that vertices that skinning can process together are adjacent.
#pragma once

#include "meshsplit/mesh.h"

namespace claque::meshsplit
{

// Returns the order of all vertices: by number of influences; within one number first the vertices that fill blocks
// with the same palette entries (lib/model/skin_plan.h), then the others; within these by entries, weights and first
// use.
std::vector<uint32_t> skinning_order(const Mesh &mesh);

}  // namespace claque::meshsplit
