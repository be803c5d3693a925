// The kernels that SkinJob calls. Internal to lib/skin.
#pragma once

#include <cstdint>

#include "lib/base/span.h"
#include "lib/math/affine.h"
#include "lib/model/skin_plan.h"
#include "lib/skin/pack.h"

namespace claque::skin
{

// Matrices of four columns of four floats, aligned to 32 bytes, so that a column is one aligned load. The fourth float
// of a column is unspecified.
constexpr size_t aligned_matrix_floats = 16;
void align_matrices(base::Span<const math::Affine> palette, float *out);

// Vertices with the same number of influences.
struct Run {
    uint32_t count = 0;
    uint32_t influences = 1;
    const float *positions = nullptr, *normals = nullptr;  // 3 per vertex
    const uint16_t *joints = nullptr;                      // `influences` per vertex
    const float *weights = nullptr;                        // likewise; not read if influences is 1
    const float *palette = nullptr;                        // aligned matrices
    const float *normal_palette = nullptr;                 // null: palette
    float *out_positions = nullptr, *out_normals = nullptr;

    // Moves the inputs forward by `done` vertices; count and outputs stay.
    void advance(size_t done)
    {
        positions += 3 * done, normals += 3 * done;
        joints += done * influences, weights += done * influences;
    }
};

struct Float3 {
    float x, y, z;
};

// Output of packed vertices, from vertex 0 on; null: they stay floats.
struct PackedOutput {
    PackRange range;
    PackedPosition *positions = nullptr;
    PackedNormal *normals = nullptr;
};

// Blocks with the same number of influences, at most model::max_block_influences.
struct BlockRun {
    const model::LaneBlock *blocks = nullptr;
    uint32_t count = 0;
    uint32_t influences = 1;
    const model::Lanes *lanes = nullptr;    // of the plan
    const float *palette = nullptr;         // aligned matrices
    const float *normal_palette = nullptr;  // null: palette
    uint32_t vertex_count = 0;              // room for vertices; those after a block are written later
    Float3 *out_positions = nullptr, *out_normals = nullptr;  // of vertex 0
    PackedOutput packed;                                      // replaces the float outputs
};

// Blends sets of joints and weights into the matrices that their vertices follow.
struct SetRun {
    uint32_t count = 0;
    uint32_t influences = 1;
    const uint16_t *joints = nullptr;
    const float *weights = nullptr;
    const float *palette = nullptr;  // aligned matrices
    float *out = nullptr;            // aligned matrices, one per set
};

void run_scalar(const Run &run);
void run_128(const Run &run);
void blend_128(const SetRun &run);
void run_128_blocks(const BlockRun &run);
void run_128_avx_blocks(const BlockRun &run);  // the same lanes in fewer instructions; requires math::has_avx()

void run_256(const Run &run);
void run_256_blocks(const BlockRun &run);
void run_256_fma_blocks(const BlockRun &run);  // not bit-equal: products are not rounded

}  // namespace claque::skin
