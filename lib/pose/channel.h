// One animated property at one time, as glTF 2.0 says (3.11, appendix C): STEP, LINEAR, CUBICSPLINE; the time is
// clamped to the channel's own keys. No state: any time costs the same, whatever was asked before.
#pragma once

#include "lib/model/rig.h"

namespace claque::pose
{

// Between key and key + 1, `f` of the way in [0, 1); f = 0 means exactly at `key`.
struct KeyInterval {
    uint32_t key = 0;
    double f = 0;
};

// times ascend strictly. Keys at a uniform rate are found at once, others by halving.
KeyInterval find_key(const float *times, uint32_t count, double time_s);

// `out` takes channel.component_count numbers. Not for rotations.
void sample_numbers(const model::Rig &rig, const model::Channel &channel, KeyInterval place, float *out);

// A unit quaternion: LINEAR by the shorter arc, CUBICSPLINE renormalised.
glm::quat sample_rotation(const model::Rig &rig, const model::Channel &channel, KeyInterval place);

}  // namespace claque::pose
