// Skinned vertices in 12 bytes instead of 24, in forms that GL 1.1 takes as they are: positions as GL_SHORT with one
// uniform step and one offset, which the host's matrix applies, normals as GL_BYTE. SPEC 2, rows D.
#pragma once

#include "lib/base/span.h"
#include "lib/base/status.h"
#include "lib/math/simd_level.h"
#include "lib/model/template.h"

namespace claque::skin
{

using math::default_simd_level;
using math::SimdLevel;

// A position p is kept as the whole numbers nearest to (p - offset) / step, halves to the even one, within 16 bits.
struct PackRange {
    float offset[3] = {0, 0, 0};
    float step = 1;
};

// Holds every pose that the template's Sklsroot Bsphere holds, in steps of its radius / 32767: a position is wrong by
// half a step along each axis at most, 15 micrometres for a sphere of 1 m. Where clips are blended, of a sphere of
// `blend_radius` about the same centre: blends leave the other one.
PackRange pack_range(const model::Template &tmpl, float blend_radius = 0);

// glVertexPointer(3, GL_SHORT, 8), or 4 numbers: w is 1.
struct PackedPosition {
    int16_t x = 0, y = 0, z = 0, w = 1;
};

// glNormalPointer(GL_BYTE, 4). Of length 127, whatever the normal's was (GL_NORMALIZE takes its length away); 0 0 0
// where it had none. Directions are wrong by 0.4 degrees at most.
struct PackedNormal {
    int8_t x = 0, y = 0, z = 0, none = 0;
};

// Floats that are there already; SkinJob makes packed vertices without them.
// Numbers out of range, infinite or none at all become some number of the range, the same one with every kernel.
struct PackJob {
    // in
    base::Span<const float> positions;  // 3 a vertex
    base::Span<const float> normals;    // 3 a vertex, as many
    PackRange range;
    SimdLevel simd_level = default_simd_level();

    // out
    base::Span<PackedPosition> out_positions;  // one a vertex
    base::Span<PackedNormal> out_normals;      // one a vertex

    base::Status check() const;  // the first broken rule of lengths
    void run() const;            // requires check(); allocates nothing
};

// What GL makes of a packed position.
inline glm::vec3 unpacked(const PackedPosition &p, const PackRange &range)
{
    return glm::vec3(float(p.x) * range.step + range.offset[0], float(p.y) * range.step + range.offset[1],
                     float(p.z) * range.step + range.offset[2]);
}

}  // namespace claque::skin
