// The extents of nodes from the keys of channels: no pose is evaluated.
#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "meshsplit/blend_reach.h"
#include "meshsplit/largest.h"

namespace claque::meshsplit
{

namespace
{

using model::ChannelTarget;

// Between two keys each tangent of a cubic spline adds at most 4/27 of the interval.
constexpr double tangent_share = 0.1482;

glm::vec3 vector_at(const float *values) { return glm::vec3(values[0], values[1], values[2]); }

// How far the spline may leave key `k`, on the way to both neighbours.
double overshoot(const model::Rig &rig, const model::Channel &channel, uint32_t k)
{
    if (channel.interpolation != model::Interpolation::cubic_spline) return 0;
    const float *times = rig.times.data() + channel.first_time;
    const float *keys = rig.values.data() + channel.first_value;
    const auto tangent = [&](uint32_t key, uint32_t which) {
        return glm::length(glm::dvec3(vector_at(keys + (size_t(3) * key + which) * 3)));
    };
    double maximum = 0;
    for (const uint32_t left : {k > 0 ? k - 1 : k, k}) {
        if (left + 1 >= channel.key_count) continue;
        const double gap = double(times[left + 1]) - double(times[left]);
        maximum = std::max(maximum, tangent_share * gap * (tangent(left, 2) + tangent(left + 1, 0)));
    }
    return maximum;
}

// A key's own value lies between its tangents.
const float *value_of(const model::Rig &rig, const model::Channel &channel, uint32_t k)
{
    const bool cubic = channel.interpolation == model::Interpolation::cubic_spline;
    return rig.values.data() + channel.first_value + (cubic ? size_t(3) * k + 1 : size_t(k)) * channel.component_count;
}

void add_channel(const model::Rig &rig, const model::Channel &channel, NodeExtent &extent)
{
    const math::Trs &rest = rig.rest[channel.node];
    if (channel.target == ChannelTarget::rotation) {
        extent.turns = true;
        return;
    }
    for (uint32_t k = 0; k < channel.key_count; ++k) {
        const glm::vec3 value = vector_at(value_of(rig, channel, k));
        const double more = overshoot(rig, channel, k);
        if (channel.target == ChannelTarget::translation) {
            const glm::dvec3 at(value);
            extent.offset = std::max(extent.offset, glm::length(at) + more);
            extent.offset_range = std::max(extent.offset_range, glm::distance(at, glm::dvec3(rest.translation)) + more);
        } else {
            extent.scale = std::max(extent.scale, largest(value) + more);
            extent.scale_range = std::max(extent.scale_range, largest(value - rest.scale) + more);
        }
    }
}

}  // namespace

void add_clip(const model::Rig &rig, uint32_t clip, std::vector<NodeExtent> &extents)
{
    const model::Clip &of = rig.clips[clip];
    for (uint32_t c = 0; c < of.channel_count; ++c) {
        const model::Channel &channel = rig.channels[of.first_channel + c];
        if (channel.target != ChannelTarget::morph_weights) add_channel(rig, channel, extents[channel.node]);
    }
}

}  // namespace claque::meshsplit
