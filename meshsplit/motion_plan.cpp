#include "meshsplit/motion_plan.h"

#include <algorithm>
#include <cmath>

namespace claque::meshsplit
{

using model::ChannelTarget;

namespace
{

// Returns whether the channel only keeps its target at rest.
bool rests(const model::Rig &rig, const model::Channel &channel)
{
    const math::Trs &trs = channel.target == ChannelTarget::morph_weights ? rig.rest[0] : rig.rest[channel.node];
    const float rest_rotation[4] = {trs.rotation.x, trs.rotation.y, trs.rotation.z, trs.rotation.w};
    const float *rest = channel.target == ChannelTarget::translation ? &trs.translation.x
                        : channel.target == ChannelTarget::scale     ? &trs.scale.x
                        : channel.target == ChannelTarget::rotation  ? rest_rotation
                                                                     : nullptr;
    if (!rest) return false;
    const bool cubic = channel.interpolation == model::Interpolation::cubic_spline;
    const uint32_t n = channel.component_count, groups = (cubic ? 3 : 1) * channel.key_count;
    for (uint32_t g = 0; g < groups; ++g)
        for (uint32_t k = 0; k < n; ++k) {
            const float value = rig.values[channel.first_value + size_t(g) * n + k];
            const float wanted = cubic && g % 3 != 1 ? 0 : rest[k];
            if (!(std::fabs(value - wanted) <= 1e-6f * (1 + std::fabs(wanted)))) return false;
        }
    return true;
}

struct Moves {
    bool joint = false, translation = false, scale = false;
};

void add_morphs(const model::Rig &rig, uint32_t set_index, model::Motion &out)
{
    const model::MorphSet &set = rig.morph_sets[set_index];
    for (uint32_t i = 0; i < set.target_count; i += 4)
        out.groups.push_back({ChannelTarget::morph_weights, set.first_weight + i, std::min(4u, set.target_count - i)});
}

}  // namespace

void plan_joints(const model::Rig &rig, model::Motion &out)
{
    std::vector<Moves> moves(rig.node_count());
    std::vector<uint8_t> morphs(rig.morph_sets.size());
    for (const model::Channel &channel : rig.channels) {
        if (channel.target == ChannelTarget::morph_weights) {
            morphs[channel.node] = 1;
        } else if (!rests(rig, channel)) {
            Moves &m = moves[channel.node];
            m.joint = true;
            m.translation |= channel.target == ChannelTarget::translation;
            m.scale |= channel.target == ChannelTarget::scale;
        }
    }
    for (const model::Dof &dof : rig.dofs)
        if (dof.kind != model::DofKind::morph) {
            moves[dof.node].joint = true;
            moves[dof.node].translation |= dof.kind == model::DofKind::translation;
        }
    for (uint32_t n = 0; n < rig.node_count(); ++n)
        if (moves[n].joint) out.nodes.push_back(n);
    std::stable_sort(out.nodes.begin(), out.nodes.end(),
                     [&](uint32_t a, uint32_t b) { return rig.deactivation_of(a) > rig.deactivation_of(b); });
    for (uint32_t j = 0; j < out.nodes.size(); ++j) {
        if (moves[out.nodes[j]].translation) out.groups.push_back({ChannelTarget::translation, j, 3});
        if (moves[out.nodes[j]].scale) out.groups.push_back({ChannelTarget::scale, j, 3});
    }
    while (out.nodes.size() % model::motion_lanes != 0) out.nodes.push_back(model::none);
    for (uint32_t s = 0; s < morphs.size(); ++s)
        if (morphs[s]) add_morphs(rig, s, out);
}

}  // namespace claque::meshsplit
