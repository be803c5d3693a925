// The clip of the figure of `everything`: it sways, stretches, breathes and swings its arms.
#pragma once

#include <claque/template.h>

#include <deque>
#include <vector>

namespace scenes::everything
{

// Nodes, parents first. The left arm hangs on a node that mirrors.
enum Node : uint32_t { root, spine, head = spine + 8, right_arm, lantern_node, mirror, left_arm, node_count };

constexpr uint32_t morph_targets = 2;

class Sway
{
public:
    Sway();
    Sway(const Sway &) = delete;
    Sway &operator=(const Sway &) = delete;
    // Valid as long as this object.
    const clq_clip_def &clip() const { return clip_; }

private:
    std::vector<float> &values();
    void turn(uint32_t node, double axis_x, double axis_z, double angle, double lag);

    std::vector<float> times_;
    std::deque<std::vector<float>> values_;
    std::vector<clq_channel_def> channels_;
    clq_clip_def clip_ = {};
};

}  // namespace scenes::everything
