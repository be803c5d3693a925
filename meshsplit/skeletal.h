// Skeletal LOD of skinned vertices, S0 5.2: moves weights of stopped nodes to the remaining skeleton, once, at
// start-up.
#pragma once

#include "lib/model/rig.h"

namespace claque::meshsplit
{

// Returns the replacement of each palette entry for the `active` nodes: the entry itself if its node is active, else
// one of the nearest active ancestor, which moves a vertex like that node with its descendants at rest. Entries that
// are not in `used` stay. Missing entries are appended to the palette. An existing entry is reused if no vertex within
// `extent` of the origin of bind space differs by more than 1e-5 of its distance. The node of a used entry must be
// active or have an active ancestor.
std::vector<uint32_t> surviving_entries(model::Rig &rig, const std::vector<uint8_t> &active,
                                        const std::vector<uint8_t> &used, float extent);

}  // namespace claque::meshsplit
