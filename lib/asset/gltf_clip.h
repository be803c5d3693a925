// Animations to clips over the rig.
#pragma once

#include "lib/asset/gltf_nodes.h"

namespace claque::asset
{

// Where a file's nodes went: none for those that are not part of the rig.
struct RigMapping {
    std::vector<uint32_t> node;       // by node of the file
    std::vector<uint32_t> morph_set;  // by node of the file
};

// Number of morph targets that a node of the file can have animated; 0 for none.
using TargetCounts = std::vector<uint32_t>;

// Adds clips, channels, key times, values and what extras say to the rig. Channels of nodes outside the rig are checked and left out.
void read_clips(File &file, const NodeTree &tree, const TargetCounts &targets, const RigMapping &mapping,
                model::Rig &rig);

}  // namespace claque::asset
