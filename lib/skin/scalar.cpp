// The reference: one float at a time. All other kernels do the same steps in the same order.
#include "lib/skin/kernel.h"

namespace claque::skin
{

namespace
{

void blend(const float *palette, const uint16_t *joints, const float *weights, uint32_t influences, float m[16])
{
    const float *first = palette + aligned_matrix_floats * joints[0];
    if (influences == 1) {
        for (int i = 0; i < 16; ++i) m[i] = first[i];
        return;
    }
    for (int i = 0; i < 16; ++i) m[i] = first[i] * weights[0];
    for (uint32_t k = 1; k < influences; ++k) {
        const float *next = palette + aligned_matrix_floats * joints[k];
        for (int i = 0; i < 16; ++i) m[i] = m[i] + next[i] * weights[k];
    }
}

}  // namespace

void run_scalar(const Run &run)
{
    for (uint32_t v = 0; v < run.count; ++v) {
        const uint16_t *joints = run.joints + size_t(v) * run.influences;
        const float *weights = run.weights + size_t(v) * run.influences;
        float m[16];
        blend(run.palette, joints, weights, run.influences, m);
        const float *p = run.positions + 3 * size_t(v);
        for (int i = 0; i < 3; ++i)
            run.out_positions[3 * size_t(v) + i] = m[i] * p[0] + m[4 + i] * p[1] + m[8 + i] * p[2] + m[12 + i];
        if (run.normal_palette) blend(run.normal_palette, joints, weights, run.influences, m);
        const float *n = run.normals + 3 * size_t(v);
        for (int i = 0; i < 3; ++i)
            run.out_normals[3 * size_t(v) + i] = m[i] * n[0] + m[4 + i] * n[1] + m[8 + i] * n[2];
    }
}

}  // namespace claque::skin
