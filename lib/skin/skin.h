// Skins a level's vertices by a matrix palette into positions and normals of one individual, in arrays that GL accepts
// (S1 4), as floats or packed. Source vertices are skinned first, then copied to the duplicates that the fused strategy
// needs.
#pragma once

#include <vector>

#include "lib/base/span.h"
#include "lib/base/status.h"
#include "lib/model/template.h"
#include "lib/skin/pack.h"

namespace claque::skin
{

using math::can_run;

// How normals are transformed.
enum class Normals : uint8_t {
    by_palette = 0,      // by the blended palette matrix: correct if template.similar_only
    by_own_matrices = 1  // by the blend of math::normal_matrix of each palette entry
};

// Normals are not normalised: GL_NORMALIZE does it, and scales must not be lost before it.
struct SkinJob {
    // in
    const model::Level *level = nullptr;
    base::Span<const math::Affine> palette;  // every entry that the level uses, followed by one more readable float
    base::Span<const float> morph_weights;   // of the pose; empty: none
    Normals normals = Normals::by_palette;
    SimdLevel simd_level = default_simd_level();

    // scratch
    base::Span<float> scratch;  // [scratch_floats(level, palette.count, normals)]

    // out
    base::Span<float> out_positions;  // [3 * level.vertex_count]
    base::Span<float> out_normals;    // [3 * level.vertex_count]

    // Replace the two above unless empty: the results of PackJob, without an intermediate array.
    base::Span<PackedPosition> out_packed_positions;  // [level.vertex_count]
    base::Span<PackedNormal> out_packed_normals;      // likewise
    PackRange range;

    base::Status check() const;  // reports the first inconsistent length; joint indices were checked by meshsplit
    void run() const;            // requires check(); allocates nothing
};

size_t scratch_floats(const model::Level &level, size_t palette_count, Normals normals);

inline Normals normals_of(const model::Template &tmpl)
{
    return tmpl.similar_only ? Normals::by_palette : Normals::by_own_matrices;
}

}  // namespace claque::skin
