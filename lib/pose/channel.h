// Samples one channel at one time, as in glTF 2.0 (3.11, appendix C): STEP, LINEAR, CUBICSPLINE. The time is clamped to
// the channel's own keys. It keeps no state, so any time costs the same.
#pragma once

#include "lib/model/rig.h"

namespace claque::pose
{

// A time between `key` and `key + 1`: the fraction `f` is in [0, 1); f = 0 means exactly at `key`.
struct KeyInterval {
    uint32_t key = 0;
    double f = 0;
};

// `times` are strictly ascending. Keys at a uniform rate are found directly, others by binary search.
KeyInterval find_key(const float *times, uint32_t count, double time_s);

// `out` gets channel.component_count numbers. Not for rotations.
void sample_numbers(const model::Rig &rig, const model::Channel &channel, KeyInterval place, float *out);

// Returns a unit quaternion: LINEAR along the shorter arc, CUBICSPLINE normalised.
glm::quat sample_rotation(const model::Rig &rig, const model::Channel &channel, KeyInterval place);

}  // namespace claque::pose
