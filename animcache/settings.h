// What a host chooses about caches. None of it changes what is shown, but for the law of the period and the rounding of
// packed geometry.
#pragma once

#include "animcache/keypose.h"
#include "animcache/period.h"

namespace claque::animcache
{

// What is used again in a later frame (S1 Fig. 8).
enum class Mode : uint8_t {
    full = 0,       // matrix palettes, and skinned positions and normals
    animation = 1,  // matrix palettes; skinned anew each frame
    none = 2        // nothing; poses are still those of the last tick
};

// How skinned vertices are kept and handed to GL (SPEC 2; peers keep floats).
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
    float metres_per_unit = 1;  // of world positions and the law's distances
};

}  // namespace claque::animcache
