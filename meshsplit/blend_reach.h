// Bounds how far blended poses reach (S2 3.3). Layers may rotate every joint in ways that no clip does, so the bounds
// use only lengths.
#pragma once

#include <vector>

#include "lib/model/template.h"

namespace claque::meshsplit
{

// The range of one node's own transform over all clips.
struct NodeExtent {
    double offset = 0;                  // longest translation
    double offset_range = 0;            // largest distance from the rest translation
    double scale = 1, scale_range = 0;  // likewise
    double shift = 0;                   // by degrees of freedom
    bool turns = false;
};
// Nothing if the clips have more poses than `most`.
std::vector<NodeExtent> node_extents(const model::Rig &rig, uint64_t maximum = ~0ull);
// The same from the keys of all channels, read once: never less, and more where a spline could overshoot.
std::vector<NodeExtent> key_extents(const model::Rig &rig);
// Widens the extents by the keys of one clip.
void add_clip(const model::Rig &rig, uint32_t clip, std::vector<NodeExtent> &extents);

// Fills sklsroot and node_reach from lengths alone: larger than what a search of the poses finds.
void bound_by_lengths(const std::vector<NodeExtent> &extents, model::Template &tmpl);

// Fills Template::blend_reach and blend_radius; requires the levels and the Sklsroot Bsphere. `extents`: of the
// template's rig.
void find_blend_reach(const std::vector<NodeExtent> &extents, model::Template &tmpl);

}  // namespace claque::meshsplit
