// Resamples clips: fills Template::motion from the channels of its rig. It selects the nodes that are joints and, for
// each clip, the rate that follows its channels within a given error, and records that error.
#pragma once

#include "lib/model/template.h"

namespace claque::meshsplit
{

// The largest allowed deviation of a resampled clip from its channels, at any key, between keys and between rows.
struct MotionTolerance {
    float metres = automatic;  // of any vertex or node; 0: clips keep their channels
    float radians = 0.01f;     // rotation of any node

    // 1/2000 of the radius of the character at rest: half a millimetre for a human.
    static constexpr float automatic = -1;
};

// What resampling may hold in bytes and evaluate in local transforms. Clips that need more keep their channels; if even
// that is more, the template has no motion, and all clips are sampled from their channels.
struct MotionLimits {
    uint64_t bytes = ~0ull, transforms = ~0ull;
};

// Requires rig and levels of `out`. Returns a bound of how much further resampled clips can reach than their channels.
float make_motion(const MotionTolerance &tolerance, model::Template &out, const MotionLimits &limits = {});
// Enlarges the bounding spheres of `out` by `more`, so that they also hold for resampled clips.
void inflate(float more, model::Template &out);

}  // namespace claque::meshsplit
