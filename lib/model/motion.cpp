#include "lib/model/motion.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <vector>

#include "lib/base/error.h"

namespace claque::model
{

using base::fail;

namespace
{

template <class T>
uint64_t size_of(const Array<T> &array)
{
    return array.size() * sizeof(T);
}

void fill_rotations(const Rig &rig, Motion &m)
{
    m.rest_rotations.assign(size_t(block_numbers) * m.block_count(), 0.0f);
    m.rest_scales.assign(size_t(3) * m.nodes.size(), 1.0f);
    m.rest_offsets.assign(size_t(4) * m.nodes.size(), 0.0f);
    for (uint32_t j = 0; j < m.nodes.size(); ++j) {
        const math::Trs trs = m.nodes[j] == none ? math::Trs() : rig.rest[m.nodes[j]];
        const uint32_t lane = j % motion_lanes;
        float *rotation = m.rest_rotations.data() + size_t(block_numbers) * (j / motion_lanes) + lane;
        float *scale = m.rest_scales.data() + size_t(3) * motion_lanes * (j / motion_lanes) + lane;
        rotation[0] = trs.rotation.x, rotation[motion_lanes] = trs.rotation.y;
        rotation[2 * motion_lanes] = trs.rotation.z, rotation[3 * motion_lanes] = trs.rotation.w;
        for (int k = 0; k < 3; ++k) {
            scale[size_t(k) * motion_lanes] = trs.scale[k];
            m.rest_offsets[4 * size_t(j) + size_t(k)] = trs.translation[k];
        }
    }
}

// The node of the first morph set that has a weight, for all weights; 0 where there is none.
std::vector<uint32_t> nodes_of_weights(const Rig &rig)
{
    std::vector<uint32_t> out(rig.rest_weights.size());
    for (size_t s = rig.morph_sets.size(); s-- > 0;) {
        const MorphSet &set = rig.morph_sets[s];
        std::fill_n(out.begin() + set.first_weight, set.target_count, set.node);
    }
    return out;
}

void fill_groups(const Rig &rig, Motion &m)
{
    m.rest_groups.assign(4 * m.groups.size(), 0.0f);
    m.group_of.assign(2 * m.nodes.size(), none);
    m.group_nodes.clear();
    m.scales_move = false;
    const std::vector<uint32_t> weight_nodes = nodes_of_weights(rig);
    for (uint32_t g = 0; g < m.groups.size(); ++g) {
        const MotionGroup &group = m.groups[g];
        const bool scales = group.target == ChannelTarget::scale, morphs = group.target == ChannelTarget::morph_weights;
        if (!morphs) m.group_of[2 * group.index + (scales ? 1 : 0)] = g;
        m.group_nodes.push_back(morphs ? weight_nodes[group.index] : m.nodes[group.index]);
        m.scales_move |= scales;
        for (uint32_t k = 0; k < group.count; ++k) {
            float &to = m.rest_groups[4 * size_t(g) + k];
            if (morphs) to = rig.rest_weights[group.index + k];
            else if (scales) to = rig.rest[m.nodes[group.index]].scale[int(k)];
            else to = rig.rest[m.nodes[group.index]].translation[int(k)];
        }
    }
}

void fill_still(const Rig &rig, Motion &m)
{
    m.still_nodes.clear(), m.still_columns.clear();
    for (uint32_t n = 0; n < rig.node_count(); ++n) {
        if (m.joint_of[n] != none) continue;
        m.still_nodes.push_back(n);
        const math::Affine local = math::affine_of(rig.rest[n]);
        for (int k = 0; k < 4; ++k)
            m.still_columns.insert(m.still_columns.end(), {local.c[3 * k], local.c[3 * k + 1], local.c[3 * k + 2], 0});
    }
}

void check_group(const Motion &m, const Rig &rig, const MotionGroup &group)
{
    if (group.target == ChannelTarget::rotation || group.target > ChannelTarget::morph_weights)
        fail(CLQ_ARGUMENT, "a motion group of target %u", unsigned(group.target));
    const bool morphs = group.target == ChannelTarget::morph_weights;
    const uint64_t owners = morphs ? rig.rest_weights.size() : m.nodes.size();
    const bool counted = morphs ? group.count >= 1 && group.count <= 4 : group.count == 3;
    if (!counted || uint64_t(group.index) + (morphs ? group.count : 1) > owners ||
        (!morphs && m.nodes[group.index] == none))
        fail(CLQ_ARGUMENT, "a motion group holds %u numbers from number %u on, and there are %llu", group.count,
             group.index, static_cast<unsigned long long>(owners));
}

void check_rows(uint64_t first, uint64_t stride, uint64_t intervals, uint64_t numbers, uint64_t length)
{
    // Sampling reads a row and its successor, also when there is only one row.
    if (first + stride * std::max<uint64_t>(intervals, 1) + numbers > length)
        fail(CLQ_ARGUMENT, "rows of motion from %llu on exceed their %llu numbers",
             static_cast<unsigned long long>(first), static_cast<unsigned long long>(length));
}

// A node that a degree of freedom shifts needs a group to add the shift to.
void check_shifts(const Motion &m, const Rig &rig)
{
    std::vector<bool> shifts(rig.node_count());
    for (const MotionGroup &group : m.groups)
        if (group.target == ChannelTarget::translation) shifts[m.nodes[group.index]] = true;
    for (const Dof &dof : rig.dofs)
        if (dof.kind == DofKind::translation && !shifts[dof.node])
            fail(CLQ_ARGUMENT, "motion has no group for the translation of node %u", dof.node);
}

// An exact channel belongs to this clip and its index matches its target. `numbers`: of the groups before each.
void check_exact(const Motion &m, const Rig &rig, const Clip &clip, const MotionExactChannel &exact,
                 const std::vector<uint64_t> &numbers)
{
    if (exact.channel < clip.first_channel || exact.channel - clip.first_channel >= clip.channel_count)
        fail(CLQ_ARGUMENT, "channel %u is kept by motion of another clip", exact.channel);
    const Channel &channel = rig.channels[exact.channel];
    if (channel.target == ChannelTarget::rotation) {
        if (exact.index >= m.nodes.size()) fail(CLQ_ARGUMENT, "motion keeps channel %u for no joint", exact.channel);
        return;
    }
    const uint64_t groups = (uint64_t(channel.component_count) + 3) / 4, count = m.groups.size();
    const uint64_t first = std::min<uint64_t>(exact.index, count), last = std::min(exact.index + groups, count);
    const uint64_t kept = numbers[last] - numbers[first];
    if (kept != channel.component_count)
        fail(CLQ_ARGUMENT, "motion keeps %llu numbers of channel %u, which has %u", base::big(kept), exact.channel,
             channel.component_count);
}

void check_clip(const Motion &m, const Rig &rig, uint32_t c, const std::vector<uint64_t> &numbers)
{
    const MotionClip &clip = m.clips[c];
    const bool sound = std::isfinite(clip.rate_hz) && clip.rate_hz >= 0 && clip.error_m >= 0 && clip.error_rad >= 0;
    if (!sound || clip.intervals > max_motion_intervals)
        fail(CLQ_ARGUMENT, "motion of clip %u at %g Hz in %u intervals", c, double(clip.rate_hz), clip.intervals);
    for (uint32_t b = 0; b < m.block_count(); ++b) {
        const MotionBlock &block = m.blocks[size_t(c) * m.block_count() + b];
        if (block.first != none)
            check_rows(block.first, block.stride, clip.intervals, block_numbers, m.rotations.size());
    }
    for (uint32_t g = 0; g < m.group_count(); ++g) {
        const MotionCurve &curve = m.curves[size_t(c) * m.group_count() + g];
        check_rows(curve.first, curve.stride, clip.intervals, 4, m.numbers.size());
        for (int k = 0; k < 4; ++k)
            if (!std::isfinite(curve.min[k]) || !std::isfinite(curve.step[k]))
                fail(CLQ_ARGUMENT, "motion of clip %u has a range that is not finite", c);
    }
    // Those of one clip follow those of the clip before, so each is looked at once.
    const uint64_t before = c == 0 ? 0 : uint64_t(m.clips[c - 1].first_exact) + m.clips[c - 1].exact_count;
    if (clip.first_exact != before || before + clip.exact_count > m.exact.size())
        fail(CLQ_ARGUMENT, "motion of clip %u keeps channels out of range", c);
    for (uint32_t i = 0; i < clip.exact_count; ++i)
        check_exact(m, rig, rig.clips[c], m.exact[clip.first_exact + i], numbers);
}

}  // namespace

void check(const Motion &m, const Rig &rig)
{
    if (m.empty()) return;
    if (m.clips.size() != rig.clips.size() || m.nodes.size() % motion_lanes != 0 ||
        m.blocks.size() != m.clips.size() * m.block_count() || m.curves.size() != m.clips.size() * m.groups.size())
        fail(CLQ_ARGUMENT, "motion of %zu clips and %zu joints does not fit a rig of %zu clips", m.clips.size(),
             m.nodes.size(), rig.clips.size());
    Array<uint8_t> taken(rig.node_count(), 0, m.nodes.get_allocator());
    for (const uint32_t node : m.nodes) {
        if (node == none) continue;
        if (node >= rig.node_count() || taken[node])
            fail(CLQ_ARGUMENT, "motion has a joint at node %u twice or nowhere", node);
        taken[node] = 1;
    }
    for (const MotionGroup &group : m.groups) check_group(m, rig, group);
    check_shifts(m, rig);
    std::vector<uint64_t> numbers = {0};
    for (const MotionGroup &group : m.groups) numbers.push_back(numbers.back() + group.count);
    for (uint32_t c = 0; c < m.clips.size(); ++c) check_clip(m, rig, c, numbers);
}

void derive(const Rig &rig, Motion &m)
{
    m.joint_of.assign(rig.node_count(), none);
    for (uint32_t j = 0; j < m.nodes.size(); ++j)
        if (m.nodes[j] != none) m.joint_of[m.nodes[j]] = j;
    fill_rotations(rig, m);
    fill_groups(rig, m);
    fill_still(rig, m);
}

uint64_t motion_bytes(const Motion &m, const Rig &rig, uint32_t c)
{
    if (m.empty()) return 0;
    const MotionClip &clip = m.clips[c];
    uint64_t bytes = sizeof clip + sizeof(MotionBlock) * m.block_count() + sizeof(MotionCurve) * m.group_count();
    const uint64_t rows = uint64_t(clip.intervals) + 1;
    for (uint32_t b = 0; b < m.block_count(); ++b)
        if (m.blocks[size_t(c) * m.block_count() + b].stride) bytes += rows * block_numbers * sizeof(int16_t);
    for (uint32_t g = 0; g < m.group_count(); ++g)
        if (m.curves[size_t(c) * m.group_count() + g].stride) bytes += rows * 4 * sizeof(uint16_t);
    for (uint32_t i = 0; i < clip.exact_count; ++i) {
        const Channel &channel = rig.channels[m.exact[clip.first_exact + i].channel];
        const uint64_t groups = channel.interpolation == Interpolation::cubic_spline ? 3 : 1;
        bytes += sizeof(MotionExactChannel) + sizeof channel;
        bytes += channel.key_count * (1 + groups * channel.component_count) * sizeof(float);
    }
    return bytes;
}

uint64_t motion_bytes(const Motion &m)
{
    return size_of(m.nodes) + size_of(m.groups) + size_of(m.clips) + size_of(m.blocks) + size_of(m.curves) +
           size_of(m.exact) + size_of(m.rotations) + size_of(m.numbers) + size_of(m.joint_of) + size_of(m.group_of) +
           size_of(m.group_nodes) + size_of(m.rest_rotations) + size_of(m.rest_scales) + size_of(m.rest_offsets) +
           size_of(m.rest_groups) + size_of(m.still_nodes) + size_of(m.still_columns);
}

}  // namespace claque::model
