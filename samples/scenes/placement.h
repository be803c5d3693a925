// How the file of a character is placed and what becomes of its blending, and which of its nodes walk
// (docs/characters.md, "Facing and size", "Materials and light").
#pragma once

#include <claque/assets.h>

#include <string>
#include <vector>

namespace scenes
{

struct Placement {
    double turn_deg = 0, height_m = 0, scale = 0;  // as in clq_asset_options
    clq_blend blend = CLQ_BLEND_MASK;

    bool has_size() const { return height_m != 0 || scale != 0; }
    bool any() const { return turn_deg != 0 || has_size() || blend != CLQ_BLEND_MASK; }
    void give(clq_asset_options &options) const
    {
        options.turn_deg = turn_deg, options.height_m = height_m, options.scale = scale, options.blend = blend;
    }
};

// Names of nodes; empty: found by their usual names.
struct WalkingNodes {
    std::vector<std::string> legs;  // thigh, shin and foot of the left leg, then of the right; or toes too, behind feet
    std::string torso, neck, head;
};

}  // namespace scenes
