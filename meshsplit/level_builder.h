// A merged mesh in the form that skinning and drawing read: model::Level.
#pragma once

#include "lib/model/template.h"
#include "meshsplit/mesh.h"
#include "meshsplit/streams.h"

namespace claque::meshsplit
{

// Fills everything but distance and skeleton. The mesh's surfaces name textures of the template.
void build_level(Mesh &mesh, const TriangleZones &zones, const model::Rig &rig, model::Level &out);

// What is left of the skeleton at each level: skeletal, active, nodes, entries. `active` has one list a level.
void set_skeletons(const std::vector<const std::vector<uint8_t> *> &active, size_t entry_count,
                   model::Array<model::Level> &levels);

}  // namespace claque::meshsplit
