// What SkinJob calls for the parts of a level.
#pragma once

#include "lib/base/span.h"
#include "lib/math/affine.h"
#include "lib/model/skin_plan.h"
#include "lib/skin/pack.h"

#include <cstdint>

namespace claque::skin
{

// Matrices of four columns of four floats, aligned to 32 bytes, so that a column is one aligned load; a column's fourth float
// may be anything.
constexpr size_t aligned_matrix_floats = 16;
void align_matrices(base::Span<const math::Affine> palette, float *out);

// Vertices of one number of influences.
struct Run {
    uint32_t count = 0;
    uint32_t influences = 1;
    const float *positions = nullptr, *normals = nullptr;  // 3 a vertex
    const uint16_t *joints = nullptr;                      // `influences` a vertex
    const float *weights = nullptr;                        // likewise; not read where influences is 1
    const float *palette = nullptr;                        // aligned matrices
    const float *normal_palette = nullptr;                 // null: palette
    float *out_positions = nullptr, *out_normals = nullptr;

    // From the `done`th of these vertices on; count and where they go stay.
    void advance(size_t done)
    {
        positions += 3 * done, normals += 3 * done;
        joints += done * influences, weights += done * influences;
    }
};

struct Float3 {
    float x, y, z;
};

// Where packed vertices go, of vertex 0 on; null: they stay floats.
struct PackedOutput {
    PackRange range;
    PackedPosition *positions = nullptr;
    PackedNormal *normals = nullptr;
};

// Blocks of one number of influences, at most model::max_block_influences.
struct BlockRun {
    const model::LaneBlock *blocks = nullptr;
    uint32_t count = 0;
    uint32_t influences = 1;
    const model::Lanes *lanes = nullptr;    // of the plan
    const float *palette = nullptr;         // aligned matrices
    const float *normal_palette = nullptr;  // null: palette
    uint32_t vertex_count = 0;              // that there is room for; those behind a block are written after it
    Float3 *out_positions = nullptr, *out_normals = nullptr;  // of vertex 0
    PackedOutput packed;                                      // instead of them
};

// Sets of joints and weights to the matrices that their vertices follow.
struct SetRun {
    uint32_t count = 0;
    uint32_t influences = 1;
    const uint16_t *joints = nullptr;
    const float *weights = nullptr;
    const float *palette = nullptr;  // aligned matrices
    float *out = nullptr;            // aligned matrices, one a set
};

void run_scalar(const Run &run);
void run_128(const Run &run);
void blend_128(const SetRun &run);
void run_128_blocks(const BlockRun &run);
void run_128_avx_blocks(const BlockRun &run);  // the same lanes in fewer instructions; requires has_avx()
bool has_avx();

void run_256(const Run &run);
void run_256_blocks(const BlockRun &run);
void run_256_fma_blocks(const BlockRun &run);  // other bits: products are not rounded

}  // namespace claque::skin
