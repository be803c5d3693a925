// Palettes from local matrices (pose.h).
#include "lib/pose/pose.h"

namespace claque::pose
{

using math::Columns;
using math::F4;

namespace
{

// Unrolled by hand, so that columns stay in registers at any optimisation level.
F4 transform(const Columns &a, float x, float y, float z)
{
    return a.c[0] * math::splat(x) + a.c[1] * math::splat(y) + a.c[2] * math::splat(z);
}

void mul_to_affine(const Columns &a, const float *b, float *out)
{
    // Each store's fourth lane is overwritten by the next store.
    math::store4(out, transform(a, b[0], b[1], b[2]));
    math::store4(out + 3, transform(a, b[3], b[4], b[5]));
    math::store4(out + 6, transform(a, b[6], b[7], b[8]));
    math::store3(out + 9, transform(a, b[9], b[10], b[11]) + a.c[3]);
}

}  // namespace

void palette_from_locals(const model::Rig &rig, const model::Level &level, const math::Affine *locals, Columns *globals,
                         math::Affine *palette)
{
    const auto place = [&](uint32_t node) {
        const float *c = locals[node].c;
        const Columns own = {
            {F4{c[0], c[1], c[2], 0}, F4{c[3], c[4], c[5], 0}, F4{c[6], c[7], c[8], 0}, F4{c[9], c[10], c[11], 0}}};
        const uint32_t parent = rig.parents[node];
        if (parent == model::none) {
            globals[node] = own;
            return;
        }
        const Columns &p = globals[parent];
        for (int k = 0; k < 4; ++k) globals[node].c[k] = transform(p, c[3 * k], c[3 * k + 1], c[3 * k + 2]);
        globals[node].c[3] += p.c[3];
    };
    const auto fill = [&](uint32_t entry) {
        mul_to_affine(globals[rig.palette[entry].node], rig.palette[entry].inverse_bind.c, palette[entry].c);
    };
    if (level.active.empty()) {
        for (uint32_t i = 0; i < rig.node_count(); ++i) place(i);
        for (uint32_t i = 0; i < rig.palette.size(); ++i) fill(i);
        return;
    }
    for (const uint32_t node : level.nodes) place(node);
    for (const uint32_t entry : level.entries) fill(entry);
}

}  // namespace claque::pose
