// A palette and a level's vertices to positions and normals of one individual, in arrays of their own that GL takes as
// they are (S1 4), floats or packed. Source vertices are skinned, then the copies that the fused strategy needs are filled.
#pragma once

#include "lib/base/span.h"
#include "lib/base/status.h"
#include "lib/model/template.h"
#include "lib/skin/pack.h"

#include <vector>

namespace claque::skin
{

using math::can_run;

// How normals are turned.
enum class Normals : uint8_t {
    by_palette = 0,      // by the blended palette matrix itself: right where template.similar_only
    by_own_matrices = 1  // by math::normal_matrix of each palette entry, blended
};

// Normals are not renormalised: GL_NORMALIZE does it, and scales must not be lost in between.
struct SkinJob {
    // in
    const model::Level *level = nullptr;
    base::Span<const math::Affine> palette;  // every entry that the level uses; one more float readable behind it
    base::Span<const float> morph_weights;   // of the pose; empty means none
    Normals normals = Normals::by_palette;
    SimdLevel simd_level = default_simd_level();

    // scratch
    base::Span<float> scratch;  // [scratch_floats(level, palette.count, normals)]

    // out
    base::Span<float> out_positions;  // [3 * level.vertex_count]
    base::Span<float> out_normals;    // [3 * level.vertex_count]
    // Instead of these two, where it is not empty: what PackJob would make of them, without the way through memory.
    base::Span<PackedPosition> out_packed_positions;  // [level.vertex_count]
    base::Span<PackedNormal> out_packed_normals;      // likewise
    PackRange range;

    base::Status check() const;  // the first broken rule of lengths; joints are trusted, as meshsplit checked them
    void run() const;            // requires check(); allocates nothing
};

size_t scratch_floats(const model::Level &level, size_t palette_count, Normals normals);

inline Normals normals_of(const model::Template &tmpl)
{
    return tmpl.similar_only ? Normals::by_palette : Normals::by_own_matrices;
}

}  // namespace claque::skin
