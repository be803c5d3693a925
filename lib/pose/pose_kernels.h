// The steps of a pose over blocks of eight joints, once for each instruction set: every number goes through the same
// operations in the same order in all of them, so results are bit-equal. No fused multiply-add, no estimates.
//
// A row of rotations is block_numbers floats a block: x of eight joints, then y, z and w. They need not be of length 1:
// what needs that makes them so itself.
#pragma once

#include "lib/math/simd.h"
#include "lib/math/simd_level.h"
#include "lib/model/motion.h"

namespace claque::pose
{

// Where a clip's rotations are read.
struct RotationRows {
    const int16_t *numbers = nullptr;
    const model::MotionBlock *blocks = nullptr;
    const float *rest = nullptr;  // for blocks that stand at rest
    uint32_t block_count = 0;
    uint32_t row = 0;
    float part = 0;  // of the way to the next row
};

// How much of a layer each joint takes: `all`, times by_joint[8 a block] where that is not null.
struct JointWeights {
    float all = 1;
    const float *by_joint = nullptr;
};

// Where joints' own matrices go.
struct JointTransforms {
    const uint32_t *nodes = nullptr;  // 8 a block, none behind the last
    const float *scales = nullptr;    // 24 a block
    const float *offsets = nullptr;   // 4 a joint
    uint32_t block_count = 0;
};

struct PoseKernels {
    void (*sample)(const RotationRows &rows, float *out);
    // pose goes towards other: by the shorter arc, on the chord.
    void (*replace)(float *pose, const float *other, const JointWeights &weights, uint32_t block_count);
    // pose turns on by a share of the turn from `reference` to `other`.
    void (*add)(float *pose, const float *other, const float *reference, const JointWeights &weights,
                uint32_t block_count);
    // Each joint's matrix relative to its parent, at out[its node].
    void (*local_matrices)(const float *rotations, const JointTransforms &places, math::Columns *out);
    // From matrices relative to parents to matrices in model space, in place; `nodes` ascend, null: all `count`.
    void (*local_to_model)(const uint32_t *parents, const uint32_t *nodes, uint32_t count, math::Columns *columns);
    // Entries of the palette; `chosen` null: all `count`. Each store overwrites one float behind its matrix.
    void (*fill_palette)(const model::PaletteEntry *entries, const uint32_t *chosen, uint32_t count,
                         const math::Columns *columns, math::Affine *out);
};

const PoseKernels &pose_kernels_of(math::SimdLevel simd_level);

extern const PoseKernels pose_kernels_scalar, pose_kernels_128, pose_kernels_256;

}  // namespace claque::pose
