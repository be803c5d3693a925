// A pose from clips as model::Motion keeps them: two rows a clip, layers mixed eight joints at a time.
#pragma once

#include "lib/base/span.h"
#include "lib/pose/layer.h"
#include "lib/pose/pose_kernels.h"

namespace claque::pose
{

// One pose in columns, as steps.h says, and the groups' numbers, four each.
struct SampledPose {
    float *rotations = nullptr;
    float *groups = nullptr;
};

class Sampler
{
public:
    // `scratch`: [sampled_floats(motion)].
    Sampler(const model::Rig &rig, const model::Motion &motion, math::SimdLevel simd_level, float *scratch);

    // Only the first blocks, up to that of the last of these nodes: what a level evaluates.
    void limit_to(base::Span<const uint32_t> nodes);

    void sample(uint32_t clip, double time_s);
    void blend(base::Span<const Layer> layers);

    // What degrees of freedom do to a node, between its rotation and its scale. Nodes that are left out stay so.
    void turn(uint32_t node, const glm::quat &by);
    void shift(uint32_t node, const glm::vec3 &along);

    void read_weights(float *weights) const;  // those that no clip moves are left alone
    // Local transforms of all nodes; those that `clip` never moves are at rest to the bit. None: all may be moved.
    void read_locals(uint32_t clip, math::Trs *locals) const;
    // Local matrices of all nodes of the first blocks, and of still nodes.
    void local_matrices(math::Columns *out) const;

private:
    void sample(uint32_t clip, double time_s, const SampledPose &out) const;
    void sample_exact(const model::MotionClip &clip, double time_s, const SampledPose &out) const;
    void blend_groups(const Layer &layer) const;
    glm::quat rotation(uint32_t joint) const;  // unit
    const float *joint_weights(const Layer &layer) const;
    SampledPose pose(int index) const;

    const model::Rig &rig_;
    const model::Motion &motion_;
    const PoseKernels &kernels_;
    float *scratch_;  // three poses, scales, weights of joints
    uint32_t blocks_;
};

size_t sampled_floats(const model::Motion &motion);

}  // namespace claque::pose
