#include "lib/pose/sampled.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "lib/math/slerp.h"
#include "lib/pose/channel.h"

namespace claque::pose
{

using math::F4;
using model::block_numbers;
using model::motion_lanes;
using model::none;

namespace
{

size_t pose_floats(const model::Motion &motion)
{
    return size_t(block_numbers) * motion.block_count() + 4 * size_t(motion.group_count());
}

size_t lane_of(uint32_t joint) { return size_t(block_numbers) * (joint / motion_lanes) + joint % motion_lanes; }

F4 widened(const uint16_t *p) { return F4{float(p[0]), float(p[1]), float(p[2]), float(p[3])}; }

// The position of a time between two rows of a clip.
struct RowPlace {
    uint32_t row = 0;
    float part = 0;

    RowPlace(const model::MotionClip &clip, double since_start_s)
    {
        const double at = since_start_s * double(clip.rate_hz);
        if (!(at > 0) || clip.intervals == 0) return;
        row = at < clip.intervals ? static_cast<uint32_t>(at) : clip.intervals - 1;
        part = static_cast<float>(std::min(at - row, 1.0));
    }
};

}  // namespace

size_t sampled_floats(const model::Motion &motion)
{
    const size_t joints = motion.nodes.size();
    return 3 * pose_floats(motion) + 3 * joints + joints + 8;
}

Sampler::Sampler(const model::Rig &rig, const model::Motion &motion, math::SimdLevel simd_level, float *scratch)
    : rig_(rig),
      motion_(motion),
      kernels_(pose_kernels_of(simd_level)),
      scratch_(scratch),
      blocks_(motion.block_count())
{
    // Aligned rows of eight floats cross no cache line.
    scratch_ = reinterpret_cast<float *>((reinterpret_cast<uintptr_t>(scratch) + 31) & ~uintptr_t(31));
}

SampledPose Sampler::pose(int index) const
{
    const size_t rotations = size_t(block_numbers) * motion_.block_count();
    return {scratch_ + index * rotations,
            scratch_ + 3 * rotations + 4 * motion_.nodes.size() + 4 * size_t(index) * motion_.group_count()};
}

void Sampler::limit_to(base::Span<const uint32_t> nodes)
{
    uint32_t joints = 0;
    for (const uint32_t node : nodes) {
        const uint32_t joint = motion_.joint_of[node];
        if (joint != none && joint >= joints) joints = joint + 1;
    }
    blocks_ = (joints + motion_lanes - 1) / motion_lanes;
}

void Sampler::sample(uint32_t clip, double time_s) { sample(clip, time_s, pose(0)); }

void Sampler::sample(uint32_t index, double time_s, const SampledPose &out) const
{
    const uint32_t groups = motion_.group_count();
    if (index == none) {
        std::copy_n(motion_.rest_rotations.data(), size_t(block_numbers) * blocks_, out.rotations);
        std::copy_n(motion_.rest_groups.data(), 4 * size_t(groups), out.groups);
        return;
    }
    const model::MotionClip &clip = motion_.clips[index];
    const RowPlace at(clip, time_s - double(rig_.clips[index].start_s));
    RotationRows rows;
    rows.numbers = motion_.rotations.data();
    rows.blocks = motion_.blocks.data() + size_t(index) * motion_.block_count();
    rows.rest = motion_.rest_rotations.data();
    rows.block_count = blocks_;
    rows.row = at.row;
    rows.part = at.part;
    kernels_.sample(rows, out.rotations);
    const model::MotionCurve *curves = motion_.curves.data() + size_t(index) * groups;
    for (uint32_t g = 0; g < groups; ++g) {
        const model::MotionCurve &curve = curves[g];
        const uint16_t *from = motion_.numbers.data() + curve.first + size_t(curve.stride) * at.row;
        const F4 a = widened(from), b = widened(from + curve.stride);
        math::store4(out.groups + 4 * size_t(g),
                     math::load4(curve.min) + math::load4(curve.step) * (a + math::splat(at.part) * (b - a)));
    }
    if (clip.exact_count) sample_exact(clip, time_s, out);
}

void Sampler::sample_exact(const model::MotionClip &clip, double time_s, const SampledPose &out) const
{
    for (uint32_t i = clip.first_exact; i < clip.first_exact + clip.exact_count; ++i) {
        const model::MotionExactChannel &exact = motion_.exact[i];
        const model::Channel &channel = rig_.channels[exact.channel];
        const KeyInterval place = find_key(rig_.times.data() + channel.first_time, channel.key_count, time_s);
        if (channel.target == model::ChannelTarget::rotation) {
            if (exact.index >= motion_lanes * blocks_) continue;
            const glm::quat q = sample_rotation(rig_, channel, place);
            float *lane = out.rotations + lane_of(exact.index);
            lane[0] = q.x, lane[motion_lanes] = q.y, lane[2 * motion_lanes] = q.z, lane[3 * motion_lanes] = q.w;
        } else {
            // Groups of four are stored one after the other, in the order of the channel's numbers.
            sample_numbers(rig_, channel, place, out.groups + 4 * size_t(exact.index));
        }
    }
}

const float *Sampler::joint_weights(const Layer &layer) const
{
    if (!layer.mask) return nullptr;
    float *weights = scratch_ + 3 * size_t(block_numbers) * motion_.block_count() + 3 * motion_.nodes.size();
    for (uint32_t j = 0; j < motion_lanes * blocks_; ++j)
        weights[j] = motion_.nodes[j] == none ? 0.0f : layer.mask[motion_.nodes[j]];
    return weights;
}

void Sampler::blend_groups(const Layer &layer) const
{
    const SampledPose now = pose(0), to = pose(1), from = layer.kind == LayerKind::add ? pose(2) : pose(0);
    for (uint32_t g = 0; g < motion_.group_count(); ++g) {
        float weight = layer.weight;
        if (layer.mask) weight *= layer.mask[motion_.group_nodes[g]];
        const size_t at = 4 * size_t(g);
        const F4 change = math::load4(to.groups + at) - math::load4(from.groups + at);
        math::store4(now.groups + at, math::load4(now.groups + at) + math::splat(weight) * change);
    }
}

void Sampler::blend(base::Span<const Layer> layers)
{
    const SampledPose now = pose(0), other = pose(1), reference = pose(2);
    bool first = true;
    for (const Layer &layer : layers) {
        const bool adds = layer.kind == LayerKind::add;
        const bool covers = !adds && layer.weight == 1 && !layer.mask;
        if (first && !covers) sample(none, 0, now);
        first = false;
        sample(layer.clip, layer.time_s, covers ? now : other);
        if (covers) continue;
        const JointWeights weights = {layer.weight, joint_weights(layer)};
        if (adds) {
            sample(layer.reference_clip, layer.reference_time_s, reference);
            kernels_.add(now.rotations, other.rotations, reference.rotations, weights, blocks_);
        } else {
            kernels_.replace(now.rotations, other.rotations, weights, blocks_);
        }
        blend_groups(layer);
    }
}

glm::quat Sampler::rotation(uint32_t joint) const
{
    const float *lane = pose(0).rotations + lane_of(joint);
    return math::unit_quat(lane[3 * motion_lanes], lane[0], lane[motion_lanes], lane[2 * motion_lanes]);
}

void Sampler::turn(uint32_t node, const glm::quat &by)
{
    const uint32_t joint = motion_.joint_of[node];
    if (joint >= motion_lanes * blocks_) return;
    const glm::quat q = rotation(joint) * by;
    float *lane = pose(0).rotations + lane_of(joint);
    lane[0] = q.x, lane[motion_lanes] = q.y, lane[2 * motion_lanes] = q.z, lane[3 * motion_lanes] = q.w;
}

void Sampler::shift(uint32_t node, const glm::vec3 &along)
{
    const uint32_t joint = motion_.joint_of[node];
    if (joint >= motion_lanes * blocks_) return;
    const glm::vec3 by = rotation(joint) * along;
    float *to = pose(0).groups + 4 * size_t(motion_.group_of[2 * joint]);
    to[0] += by.x, to[1] += by.y, to[2] += by.z;
}

void Sampler::read_weights(float *weights) const
{
    const float *from = pose(0).groups;
    for (const model::MotionGroup &group : motion_.groups) {
        if (group.target == model::ChannelTarget::morph_weights) std::copy_n(from, group.count, weights + group.index);
        from += 4;
    }
}

void Sampler::read_locals(uint32_t clip, math::Trs *locals) const
{
    std::copy(rig_.rest.begin(), rig_.rest.end(), locals);
    const model::MotionBlock *blocks =
        clip == none ? nullptr : motion_.blocks.data() + size_t(clip) * motion_.block_count();
    for (uint32_t j = 0; j < motion_lanes * blocks_; ++j) {
        const uint32_t node = motion_.nodes[j];
        if (node != none && (!blocks || (blocks[j / motion_lanes].moved >> (j % motion_lanes) & 1)))
            locals[node].rotation = rotation(j);
    }
    const float *from = pose(0).groups;
    for (const model::MotionGroup &group : motion_.groups) {
        const glm::vec3 v(from[0], from[1], from[2]);
        if (group.target == model::ChannelTarget::translation) locals[motion_.nodes[group.index]].translation = v;
        if (group.target == model::ChannelTarget::scale) locals[motion_.nodes[group.index]].scale = v;
        from += 4;
    }
}

void Sampler::local_matrices(math::Columns *out) const
{
    for (uint32_t i = 0; i < motion_.still_nodes.size(); ++i)
        std::memcpy(out + motion_.still_nodes[i], motion_.still_columns.data() + 16 * size_t(i), 16 * sizeof(float));
    const SampledPose now = pose(0);
    JointTransforms places;
    places.nodes = motion_.nodes.data();
    places.scales = motion_.rest_scales.data();
    places.offsets = motion_.rest_offsets.data();
    places.block_count = blocks_;
    if (motion_.scales_move) {
        float *scales = scratch_ + 3 * size_t(block_numbers) * motion_.block_count();
        std::copy(motion_.rest_scales.begin(), motion_.rest_scales.end(), scales);
        for (uint32_t g = 0; g < motion_.group_count(); ++g) {
            const model::MotionGroup &group = motion_.groups[g];
            if (group.target != model::ChannelTarget::scale) continue;
            float *lane = scales + size_t(3) * motion_lanes * (group.index / motion_lanes) + group.index % motion_lanes;
            for (uint32_t k = 0; k < 3; ++k) lane[k * motion_lanes] = now.groups[4 * size_t(g) + k];
        }
        places.scales = scales;
    }
    kernels_.local_matrices(now.rotations, places, out);
    for (uint32_t g = 0; g < motion_.group_count(); ++g)
        if (motion_.groups[g].target == model::ChannelTarget::translation) {
            const float *t = now.groups + 4 * size_t(g);
            out[motion_.nodes[motion_.groups[g].index]].c[3] = F4{t[0], t[1], t[2], 0};
        }
}

}  // namespace claque::pose
