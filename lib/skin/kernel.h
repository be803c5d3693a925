// Vertices of one number of influences: what SkinJob calls for each run.
#pragma once

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
    float *out_positions = nullptr, *out_normals = nullptr;
};

void run_scalar(const Run &run);
void run_vector(const Run &run);

}  // namespace claque::skin
