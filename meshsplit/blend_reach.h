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
std::vector<NodeExtent> node_extents(const model::Rig &rig);

// Fills Template::blend_reach and blend_radius; requires the levels and the Sklsroot Bsphere. `extents`: of the
// template's rig.
void find_blend_reach(const std::vector<NodeExtent> &extents, model::Template &tmpl);

}  // namespace claque::meshsplit
