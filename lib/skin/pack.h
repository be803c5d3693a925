// Packed vertices: 12 bytes instead of 24, in formats that GL 1.1 accepts. Positions are GL_SHORT with one uniform step
// and one offset, which the host's matrix applies; normals are GL_BYTE.
#pragma once

#include "lib/base/span.h"
#include "lib/base/status.h"
#include "lib/math/simd_level.h"
#include "lib/model/template.h"

namespace claque::skin
{

using math::default_simd_level;
using math::SimdLevel;

// A position p is stored as (p - offset) / step, rounded to the nearest integer, halves to even, within 16 bits.
struct PackRange {
    float offset[3] = {0, 0, 0};
    float step = 1;
};

// Returns a range that holds every pose within the template's Sklsroot Bsphere, in steps of its radius / 32767. The
// largest error is half a step along each axis: 15 micrometres for a sphere of 1 m. Blended clips can leave that
// sphere; `blend_radius` is the radius of their sphere about the same centre.
PackRange pack_range(const model::Template &tmpl, float blend_radius = 0);

// For glVertexPointer(3, GL_SHORT, 8), or 4 components: w is 1.
struct PackedPosition {
    int16_t x = 0, y = 0, z = 0, w = 1;
};

// For glNormalPointer(GL_BYTE, 4). The length is 127, whatever the normal's length was (GL_NORMALIZE removes it); 0 0 0
// for a normal of no length. The largest error of a direction is 0.4 degrees.
struct PackedNormal {
    int8_t x = 0, y = 0, z = 0, none = 0;
};

// Packs existing floats; SkinJob makes packed vertices without them. Values out of range, infinities and NaNs become
// some value of the range, the same one with every kernel.
struct PackJob {
    // in
    base::Span<const float> positions;  // 3 per vertex
    base::Span<const float> normals;    // 3 per vertex, same count
    PackRange range;
    SimdLevel simd_level = default_simd_level();

    // out
    base::Span<PackedPosition> out_positions;  // one per vertex
    base::Span<PackedNormal> out_normals;      // one per vertex

    base::Status check() const;  // reports the first inconsistent length
    void run() const;            // requires check(); allocates nothing
};

// The position that GL computes from a packed one.
inline glm::vec3 unpacked(const PackedPosition &p, const PackRange &range)
{
    return glm::vec3(float(p.x) * range.step + range.offset[0], float(p.y) * range.step + range.offset[1],
                     float(p.z) * range.step + range.offset[2]);
}

}  // namespace claque::skin
