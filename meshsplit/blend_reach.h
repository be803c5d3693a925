// How far blended poses reach (S2 3.3): layers may turn every joint as no clip does, so what bounds them are lengths.
#pragma once

#include "lib/model/template.h"

#include <vector>

namespace claque::meshsplit
{

// What all clips make of one node's own transform.
struct NodeExtent {
    double offset = 0;                  // longest translation
    double offset_range = 0;            // farthest from that at rest
    double scale = 1, scale_range = 0;  // likewise
    double shift = 0;                   // by degrees of freedom
    bool turns = false;
};
std::vector<NodeExtent> node_extents(const model::Rig &rig);

// Fills Template::blend_reach and blend_radius; the levels and the Sklsroot Bsphere are there. `spans` of its rig.
void find_blend_reach(const std::vector<NodeExtent> &extents, model::Template &tmpl);

}  // namespace claque::meshsplit
