// Samples poses from resampled clips (model::Motion): two rows per clip; layers are blended eight joints at a time.
#pragma once

#include "lib/base/span.h"
#include "lib/pose/layer.h"
#include "lib/pose/pose_kernels.h"

namespace claque::pose
{

// One pose: rotations as in pose_kernels.h, and the groups' numbers, four each.
struct SampledPose {
    float *rotations = nullptr;
    float *groups = nullptr;
};

class Sampler
{
public:
    // `scratch`: [sampled_floats(motion)].
    Sampler(const model::Rig &rig, const model::Motion &motion, math::SimdLevel simd_level, float *scratch);

    // Limits evaluation to the blocks up to the last of these nodes, for a level.
    void limit_to(base::Span<const uint32_t> nodes);

    void sample(uint32_t clip, double time_s);
    void blend(base::Span<const Layer> layers);

    // Apply degrees of freedom to a node, between its rotation and its scale. Inactive nodes are ignored.
    void turn(uint32_t node, const glm::quat &by);
    void shift(uint32_t node, const glm::vec3 &along);

    void read_weights(float *weights) const;  // weights that no clip moves are unchanged

    // Writes local transforms of all nodes. Nodes that `clip` never moves are exactly at rest. None: all may move.
    void read_locals(uint32_t clip, math::Trs *locals) const;
    // Writes local matrices of all nodes of the evaluated blocks and of nodes at rest.
    void local_matrices(math::Columns *out) const;

private:
    void sample(uint32_t clip, double time_s, const SampledPose &out) const;
    void sample_exact(const model::MotionClip &clip, double time_s, const SampledPose &out) const;
    void blend_groups(const Layer &layer) const;
    glm::quat rotation(uint32_t joint) const;  // normalised
    const float *joint_weights(const Layer &layer) const;
    SampledPose pose(int index) const;

    const model::Rig &rig_;
    const model::Motion &motion_;
    const PoseKernels &kernels_;
    float *scratch_;  // three poses, scales, joint weights
    uint32_t blocks_;
};

size_t sampled_floats(const model::Motion &motion);

}  // namespace claque::pose
