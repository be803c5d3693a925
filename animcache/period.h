// How often an individual's pose is renewed, and when (S1 4): the update period is linear in the squared distance to
// the eye and rounded to a fixed rate step. The ticks of individuals are spread so that the work is even over frames.
// What is shown is a function of time and present distance.
#pragma once

#include <cstdint>

namespace claque::animcache
{

struct PeriodLaw {
    float near_s = 0.02f;  // at d_near or nearer; 0: every frame
    float far_s = 0.25f;   // at d_far or farther
    float d_near = 5;      // world units
    float d_far = 50;
};

constexpr uint32_t rate_step_count = 13;  // 0: every frame; then 50, 40, 32, 25, 20, 16, 12.5, 10, 8, 6.25, 5, 4 Hz

double rate_hz(uint32_t rate_step);   // 0 for rate step 0
double period_s(uint32_t rate_step);  // 0 for rate step 0

double period_s(const PeriodLaw &law, double distance);  // T(d^2), before rounding to rate steps
// T rounded down to a rate step; slower than 4 Hz becomes 4 Hz
uint32_t rate_step_of(const PeriodLaw &law, double distance);

// The slowest rate step at which something that moves at `speed` (world units a second) moves by at most
// `tolerance_px` between two ticks, in a picture of 768 lines over 60 degrees; 0 where even 50 Hz is too slow.
uint32_t rate_step_of_motion(double speed, double distance, double tolerance_px);

// The last tick at or before time_s at a rate step: floor((t + phase) f) / f - phase, its phase in [0, 1/f) from the
// hash of an individual's id. At rate step 0 it is time_s itself.
double tick_s(uint32_t rate_step, double time_s, uint64_t id_hash);

}  // namespace claque::animcache
