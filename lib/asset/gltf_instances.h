// EXT_mesh_gpu_instancing: copies of a node's mesh at places of their own.
#pragma once

#include "lib/asset/gltf_nodes.h"

namespace claque::asset
{

// Adds a node for each instance, below the node that the file instances, as if the file had written them out. A skinned
// mesh is left as one, with a warning. Throws base::Error (CLQ_FORMAT, CLQ_LIMIT).
void add_instances(File &file, NodeTree &tree);

}  // namespace claque::asset
