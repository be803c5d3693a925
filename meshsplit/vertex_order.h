// In which order the vertices of a mesh stand, so that skinning finds those together that it can do together.
#pragma once

#include "meshsplit/mesh.h"

namespace claque::meshsplit
{

// Of all vertices: by number of influences; within one number those that fill blocks of neighbours on the same palette
// entries (lib/model/skin_plan.h), then the others; within these by entries, weights and first use.
std::vector<uint32_t> skinning_order(const Mesh &mesh);

}  // namespace claque::meshsplit
