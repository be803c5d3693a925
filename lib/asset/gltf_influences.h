// JOINTS_n and WEIGHTS_n, any number of sets, to one list of influences a vertex.
#pragma once

#include "lib/asset/gltf_file.h"

namespace claque::asset
{

// Fills influence_count, joints (places in a skin's list) and weights: sum 1, those that weigh something first, no more
// columns than the busiest vertex needs. A vertex without any weight follows the first joint it lists, with a warning.
// False, and nothing filled, where the primitive has no joints.
bool read_influences(File &file, const JsonView &attributes, model::Part &part);

}  // namespace claque::asset
