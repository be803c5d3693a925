// Converts a merged mesh to the form that skinning and drawing read: model::Level.
#pragma once

#include "lib/model/template.h"
#include "meshsplit/mesh.h"
#include "meshsplit/streams.h"

namespace claque::meshsplit
{

// Fills everything except distance and skeleton. The mesh's surfaces refer to textures of the template.
void build_level(Mesh &mesh, const TriangleZones &zones, const model::Rig &rig, model::Level &out);

// Sets the remaining skeleton of each level: skeletal_level, active, nodes, entries. `active` has one list per level.
void set_skeletons(const std::vector<const std::vector<uint8_t> *> &active, size_t entry_count,
                   model::Array<model::Level> &levels);

}  // namespace claque::meshsplit
