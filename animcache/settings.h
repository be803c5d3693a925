// What a host chooses about caches. None of it changes what is shown, the law of the period apart.
#pragma once

#include "animcache/period.h"

namespace claque::animcache
{

// What is used again in a later frame (S1 Fig. 8).
enum class Mode : uint8_t {
    full = 0,       // matrix palettes, and skinned positions and normals
    animation = 1,  // matrix palettes; skinned anew each frame
    none = 2        // nothing; poses are still those of the last tick
};

struct Settings {
    Mode mode = Mode::full;
    uint64_t budget_bytes = uint64_t(1) << 30;  // palettes and vertices together
    PeriodLaw period;
    float metres_per_unit = 1;  // of world positions and the law's distances
};

}  // namespace claque::animcache
