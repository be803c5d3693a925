// An individual's own time in its clip: where the clip stands is a function of the host's time alone, so nothing
// drifts and time may jump, also back.
#pragma once

#include "lib/model/rig.h"

namespace claque::pose
{

// At time t the clip stands at phase_s + speed * (t - start_s), going round.
struct ClipClock {
    double start_s = 0;  // on the host's clock
    float speed = 1;     // negative plays backwards, 0 stands still
    float phase_s = 0;
};

// On the clip's own axis, in [clip.start_s, clip.start_s + clip.duration_s); a clip of no length has only its start.
double clip_time(const ClipClock &clock, const model::Clip &clip, double time_s);

}  // namespace claque::pose
