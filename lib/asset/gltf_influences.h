// Merges any number of JOINTS_n and WEIGHTS_n sets into one list of influences per vertex.
#pragma once

#include "lib/asset/gltf_file.h"

namespace claque::asset
{

// Fills influence_count, joints (indices of a skin's list) and weights. Weights sum to 1 and joints with weight come
// first; there are no more columns than the vertex with the most influences needs. A vertex whose weights are 0, or
// no finite numbers, takes those of the weighted vertex nearest to it, with a warning; if none is weighted, each has
// the joint `none` with weight 1. Returns false and fills nothing if the primitive has no joints.
bool read_influences(File &file, const JsonView &attributes, model::Part &part);

}  // namespace claque::asset
