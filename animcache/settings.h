// The host's settings of the caches. They do not change the picture, except for the period law and the rounding of
// packed vertices.
#pragma once

#include "animcache/keypose.h"
#include "animcache/period.h"

namespace claque::animcache
{

// What is reused in later frames (S1 Fig. 8).
enum class Mode : uint8_t {
    full = 0,       // matrix palettes, and skinned positions and normals
    animation = 1,  // matrix palettes; skinned anew each frame
    none = 2        // nothing; poses are still those of the last tick
};

// How skinned vertices are stored and passed to GL (comparable libraries keep floats).
enum class VertexFormat : uint8_t {
    floats = 0,  // 24 bytes a vertex: floats
    packed = 1   // 12 bytes a vertex: 16-bit positions with one step a template, 8-bit normals (lib/skin/pack.h)
};

struct Settings {
    Mode mode = Mode::full;
    VertexFormat vertex_format = VertexFormat::floats;
    uint64_t budget_bytes = uint64_t(1) << 30;  // palettes and vertices together
    bool can_defer = false;                     // whether updates may have a budget of poses
    PeriodLaw period;
    KeyPoseSettings key_poses;
    float metres_per_unit = 1;  // converts world positions and the law's distances
};

}  // namespace claque::animcache
