// Two gaits in step: where their common phase is, and where each clip stands in it. Closed forms, so that any moment finds
// itself.
#pragma once

#include "lib/crowd/layers.h"
#include "lib/model/template.h"

namespace claque::crowd
{

// Throws base::Error (CLQ_ARGUMENT): clips of the template with a length, moments as Gait says.
void check_gait(const Gait &gait);

// 0 to 1 within `length`, without a jerk; length 0 is a step. And its integral from 0 to t.
double smooth_step(double t_s, double length_s) noexcept;
double smooth_sum(double t_s, double length_s) noexcept;

// Cycles a second at the share 0 and 1: those between go with the share.
struct Pace {
    double a = 0, b = 0;
};
Pace pace_of(const Gait &gait, float speed) noexcept;

float share_at(const Source &source, double time_s) noexcept;
// The common phase, in rounds.
double rounds_at(const Gait &gait, const Source &source, double time_s) noexcept;
// On the clip's own axis.
double time_in_a(const Gait &gait, double rounds) noexcept;
double time_in_b(const Gait &gait, double rounds) noexcept;
// The common phase, as a share of a round, at which clip a stands at a time on its own axis.
double share_of_a(const Gait &gait, double clip_time_s) noexcept;

}  // namespace claque::crowd
