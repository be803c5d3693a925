#include "meshsplit/morph_limits.h"

#include <algorithm>
#include <cmath>

namespace claque::meshsplit
{

namespace
{

void widen(WeightLimits &limits, float value, float swing)
{
    limits.low = std::min(limits.low, value - swing);
    limits.high = std::max(limits.high, value + swing);
}

// Between two keys each tangent contributes at most 4/27 of the interval.
float swing_of(float gap, float out_tangent, float in_tangent)
{
    return 0.1482f * gap * (std::fabs(out_tangent) + std::fabs(in_tangent));
}

void add_keys(const model::Rig &rig, const model::Channel &channel, WeightLimits *limits)
{
    const bool cubic = channel.interpolation == model::Interpolation::cubic_spline;
    const size_t targets = channel.component_count, stride = targets * (cubic ? 3 : 1);
    const float *times = rig.times.data() + channel.first_time, *keys = rig.values.data() + channel.first_value;
    for (uint32_t k = 0; k < channel.key_count; ++k)
        for (size_t t = 0; t < targets; ++t) {
            const float *key = keys + k * stride + t;
            const float value = cubic ? key[targets] : key[0];
            widen(limits[t], value, 0);
            if (!cubic || k == 0) continue;
            const float *before = key - stride;
            const float swing = swing_of(times[k] - times[k - 1], before[2 * targets], key[0]);
            widen(limits[t], value, swing);
            widen(limits[t], before[targets], swing);
        }
}

}  // namespace

std::vector<WeightLimits> morph_limits(const model::Rig &rig)
{
    std::vector<WeightLimits> limits;
    for (const float weight : rig.rest_weights) limits.push_back({weight, weight});
    for (const model::Clip &clip : rig.clips)
        for (uint32_t c = 0; c < clip.channel_count; ++c) {
            const model::Channel &channel = rig.channels[clip.first_channel + c];
            if (channel.target == model::ChannelTarget::morph_weights)
                add_keys(rig, channel, limits.data() + rig.morph_sets[channel.node].first_weight);
        }
    for (const model::Dof &dof : rig.dofs) {
        if (dof.kind != model::DofKind::morph) continue;
        WeightLimits &weight = limits[rig.morph_sets[dof.node].first_weight + dof.morph_target];
        weight.low += dof.min;
        weight.high += dof.max;
    }
    return limits;
}

}  // namespace claque::meshsplit
