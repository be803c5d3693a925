// The common phase of a gait's two clips, and the time of each clip at that phase. Closed forms, so that any time can
// be evaluated without the times before it.
#pragma once

#include "lib/crowd/layers.h"
#include "lib/model/template.h"

namespace claque::crowd
{

// Throws base::Error (CLQ_ARGUMENT) unless both are clips of the template with a length and the shares are as Gait
// requires.
void check_gait(const Gait &gait);

// Rises smoothly from 0 to 1 within `length`; length 0 is a step. And its integral from 0 to t.
double smooth_step(double t_s, double length_s) noexcept;
double smooth_sum(double t_s, double length_s) noexcept;

// Cycles a second at shares 0 and 1; linear in the share between them.
struct Pace {
    double a = 0, b = 0;
};
Pace pace_of(const Gait &gait, float speed) noexcept;

float share_at(const Source &source, double time_s) noexcept;
// The common phase, in cycles.
double rounds_at(const Gait &gait, const Source &source, double time_s) noexcept;
// On the clip's own axis.
double time_in_a(const Gait &gait, double rounds) noexcept;
double time_in_b(const Gait &gait, double rounds) noexcept;
// The common phase, as a fraction of a cycle, at a time on clip a's own axis.
double share_of_a(const Gait &gait, double clip_time_s) noexcept;

}  // namespace claque::crowd
