#include "animcache/period.h"

#include <algorithm>
#include <cmath>

#include "lib/base/hash.h"

namespace claque::animcache
{

namespace
{

constexpr double rates[rate_step_count] = {0, 50, 40, 32, 25, 20, 16, 12.5, 10, 8, 6.25, 5, 4};

}  // namespace

double rate_hz(uint32_t rate_step) { return rates[rate_step]; }
double period_s(uint32_t rate_step) { return rate_step == 0 ? 0 : 1 / rates[rate_step]; }

double period_s(const PeriodLaw &law, double distance)
{
    const double near2 = double(law.d_near) * law.d_near, far2 = double(law.d_far) * law.d_far;
    // Clamped here: an infinite distance times an empty span would be NaN.
    const double x = std::clamp((distance * distance - near2) / (far2 - near2), 0.0, 1.0);
    const double t = law.near_s + (double(law.far_s) - law.near_s) * x;
    return std::clamp(t, double(law.near_s), double(law.far_s));
}

uint32_t rate_step_of(const PeriodLaw &law, double distance)
{
    // The float 0.02f is a little less than 1/50; this compensates for the rounding.
    const double period = period_s(law, distance) * (1 + 1e-6);
    for (uint32_t rate_step = rate_step_count - 1; rate_step > 0; --rate_step)
        if (period * rates[rate_step] >= 1) return rate_step;
    return 0;
}

uint32_t rate_step_of_motion(double speed, double distance, double tolerance_px)
{
    constexpr double lines_per_tangent = 384 * 1.7320508075688772;  // half of 768 lines, over the tangent of 30 degrees
    const double pixels = speed * lines_per_tangent / distance;
    if (!(tolerance_px > 0) || !(pixels > 0)) return rate_step_count - 1;
    for (uint32_t rate_step = rate_step_count - 1; rate_step > 0; --rate_step)
        if (tolerance_px * rates[rate_step] >= pixels) return rate_step;
    return 0;
}

double tick_s(uint32_t rate_step, double time_s, uint64_t id_hash)
{
    if (rate_step == 0) return time_s;
    const double rate = rates[rate_step];
    const double phase = double(base::unit(id_hash)) / rate;
    return std::floor((time_s + phase) * rate) / rate - phase;
}

}  // namespace claque::animcache
