// How the file of a character is placed, what becomes of its blending and its colours, which nodes it leaves out, and
// which of them walk (docs/characters.md, "Facing and size", "Materials and light", "Colours").
#pragma once

#include <claque/assets.h>

#include <string>
#include <vector>

namespace scenes
{

struct Placement {
    double turn_deg = 0, height_m = 0, scale = 0;  // as in clq_asset_options
    clq_blend blend = CLQ_BLEND_UNSET;             // likewise
    clq_colours colours = CLQ_COLOURS_NEAR;        // likewise; they mean nothing to other characters
    std::vector<std::string> hidden = {};          // nodes

    bool has_size() const { return height_m != 0 || scale != 0; }
    bool is_placed() const { return turn_deg != 0 || has_size(); }
    bool any() const { return is_placed() || blend || !hidden.empty(); }
    // `names`: lives as long as the options.
    void give(clq_asset_options &options, std::vector<const char *> &names) const
    {
        options.turn_deg = turn_deg, options.height_m = height_m, options.scale = scale;
        options.blend = blend, options.colours = colours;
        for (const std::string &name : hidden) names.push_back(name.c_str());
        options.hidden_nodes = names.data(), options.hidden_node_count = static_cast<uint32_t>(names.size());
    }
};

// "wild" and "own" in place of a file of colours; CLQ_COLOURS_NEAR: neither.
inline clq_colours colours_of(const std::string &name)
{
    return name == "wild" ? CLQ_COLOURS_WILD : name == "own" ? CLQ_COLOURS_OWN : CLQ_COLOURS_NEAR;
}
inline const char *name_of(clq_colours colours)
{
    return colours == CLQ_COLOURS_WILD ? "wild" : colours == CLQ_COLOURS_OWN ? "own" : "near";
}

// Names of nodes; empty: found by their usual names.
struct WalkingNodes {
    std::vector<std::string> legs;  // thigh, shin and foot of the left leg, then of the right; or toes too, behind feet
    std::string torso, neck, head;
};

}  // namespace scenes
