// Reads animations as clips of the rig.
#pragma once

#include "lib/asset/gltf_nodes.h"

namespace claque::asset
{

// Maps nodes of the file to the rig; none for nodes outside the rig.
struct RigMapping {
    std::vector<uint32_t> node;       // by node of the file
    std::vector<uint32_t> morph_set;  // by node of the file
};

// The number of morph targets of each node of the file that can be animated; 0 for none.
using TargetCounts = std::vector<uint32_t>;

// Adds clips, channels, key times, values and extras to the rig. Channels of nodes outside the rig are checked and then
// dropped.
void read_clips(File &file, const NodeTree &tree, const TargetCounts &targets, const RigMapping &mapping,
                model::Rig &rig);

}  // namespace claque::asset
