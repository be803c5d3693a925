// Vertices of one number of influences: what SkinJob calls for each run.
#pragma once

#include "lib/base/span.h"
#include "lib/math/affine.h"

#include <cstdint>

namespace claque::skin
{

struct Run {
    uint32_t count = 0;
    uint32_t influences = 1;
    const float *positions = nullptr, *normals = nullptr;  // 3 a vertex
    const uint16_t *joints = nullptr;                      // `influences` a vertex
    const float *weights = nullptr;                        // likewise; not read where influences is 1
    const math::Affine *palette = nullptr;
    const math::Affine *normal_palette = nullptr;  // null: palette
    // The same palettes for run_wide, which wants both or, where normal_palette is null, the first.
    const float *wide_palette = nullptr, *wide_normal_palette = nullptr;
    float *out_positions = nullptr, *out_normals = nullptr;
};

void run_scalar(const Run &run);
void run_vector(const Run &run);

// Matrices of four columns of four floats, aligned to 32 bytes: a column's fourth float may be anything.
constexpr size_t wide_matrix_floats = 16;
void widen(base::Span<const math::Affine> palette, float *out);
void run_wide(const Run &run);

}  // namespace claque::skin
