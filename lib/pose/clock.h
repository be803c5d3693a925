// An individual's clip time. It is a function of the host's time alone, so it never drifts, and the host's time may
// jump, also backwards.
#pragma once

#include "lib/model/rig.h"

namespace claque::pose
{

// At time t the clip is at phase_s + speed * (t - start_s), and loops.
struct ClipClock {
    double start_s = 0;  // on the host's clock
    float speed = 1;     // negative plays backwards, 0 stops
    float phase_s = 0;
};

// Returns the time on the clip's own axis, in [clip.start_s, clip.start_s + clip.duration_s); for a clip of no length
// its start.
double clip_time(const ClipClock &clock, const model::Clip &clip, double time_s);

}  // namespace claque::pose
