// The steps of a pose over blocks of eight joints, one implementation for each instruction set. All do the same
// operations in the same order, so results are bit-equal. No fused multiply-add, no estimates.
//
// A row of rotations has block_numbers floats per block: x of eight joints, then y, z and w. Rotations need not have
// unit length; steps that need it normalise them.
#pragma once

#include "lib/math/simd.h"
#include "lib/math/simd_level.h"
#include "lib/model/motion.h"

namespace claque::pose
{

// The source of a clip's rotations.
struct RotationRows {
    const int16_t *numbers = nullptr;
    const model::MotionBlock *blocks = nullptr;
    const float *rest = nullptr;  // for blocks at rest
    uint32_t block_count = 0;
    uint32_t row = 0;
    float part = 0;  // fraction of the way to the next row
};

// The weight of a layer for each joint: `all` times by_joint[8 per block], if that is not null.
struct JointWeights {
    float all = 1;
    const float *by_joint = nullptr;
};

// Inputs of the joints' local matrices.
struct JointTransforms {
    const uint32_t *nodes = nullptr;  // 8 per block; none after the last joint
    const float *scales = nullptr;    // 24 per block
    const float *offsets = nullptr;   // 4 per joint
    uint32_t block_count = 0;
};

struct PoseKernels {
    void (*sample)(const RotationRows &rows, float *out);
    // Interpolates `pose` towards `other` along the shorter arc, linearly.
    void (*replace)(float *pose, const float *other, const JointWeights &weights, uint32_t block_count);
    // Rotates `pose` by a fraction of the rotation from `reference` to `other`.
    void (*add)(float *pose, const float *other, const float *reference, const JointWeights &weights,
                uint32_t block_count);
    // Writes each joint's matrix relative to its parent to out[its node].
    void (*local_matrices)(const float *rotations, const JointTransforms &places, math::Columns *out);
    // Converts matrices relative to parents to model space, in place; `nodes` ascend; null: all `count`.
    void (*local_to_model)(const uint32_t *parents, const uint32_t *nodes, uint32_t count, math::Columns *columns);
    // Writes palette entries; `chosen` null: all `count`. Each store overwrites one float after its matrix.
    void (*fill_palette)(const model::PaletteEntry *entries, const uint32_t *chosen, uint32_t count,
                         const math::Columns *columns, math::Affine *out);
};

const PoseKernels &pose_kernels_of(math::SimdLevel simd_level);

// pose_kernels_128_avx: the same lanes in fewer instructions; requires math::has_avx().
extern const PoseKernels pose_kernels_scalar, pose_kernels_128, pose_kernels_128_avx, pose_kernels_256;

}  // namespace claque::pose
