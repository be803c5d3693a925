// Skeletal LOD of skinned vertices, S0 5.2: weights of nodes that have stopped move to what is left of the skeleton,
// once, at start-up.
#pragma once

#include "lib/model/rig.h"

namespace claque::meshsplit
{

// For each palette entry the one that serves in its place where `active` is left of the nodes: itself where its node is
// active, else one of the nearest active node above, which moves a vertex as that node does with what hangs below it at
// rest. Entries that are not in `used` serve themselves. What the palette lacks is appended; an entry is taken for equal
// where no vertex within `extent` of the origin of bind space would be more than 1e-5 of its way off.
// A used entry's node has an active node above it, or is active.
std::vector<uint32_t> surviving_entries(model::Rig &rig, const std::vector<uint8_t> &active,
                                        const std::vector<uint8_t> &used, float extent);

}  // namespace claque::meshsplit
