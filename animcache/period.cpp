#include "animcache/period.h"

#include <algorithm>
#include <cmath>

#include "lib/base/hash.h"

namespace claque::animcache
{

namespace
{

constexpr double rates[rung_count] = {0, 50, 40, 32, 25, 20, 16, 12.5, 10, 8, 6.25, 5, 4};

}  // namespace

double rate_hz(uint32_t rung) { return rates[rung]; }
double period_s(uint32_t rung) { return rung == 0 ? 0 : 1 / rates[rung]; }

double period_s(const PeriodLaw &law, double distance)
{
    const double near2 = double(law.d_near) * law.d_near, far2 = double(law.d_far) * law.d_far;
    // Clamped here, or a distance beyond float's range times a span of nothing would be no number and no period.
    const double x = std::clamp((distance * distance - near2) / (far2 - near2), 0.0, 1.0);
    const double t = law.near_s + (double(law.far_s) - law.near_s) * x;
    return std::clamp(t, double(law.near_s), double(law.far_s));
}

uint32_t rung_of(const PeriodLaw &law, double distance)
{
    // A setting of 0.02f is a little less than 1/50: what float rounds away is given back.
    const double period = period_s(law, distance) * (1 + 1e-6);
    for (uint32_t rung = rung_count - 1; rung > 0; --rung)
        if (period * rates[rung] >= 1) return rung;
    return 0;
}

double tick_s(uint32_t rung, double time_s, uint64_t id_hash)
{
    if (rung == 0) return time_s;
    const double rate = rates[rung];
    const double phase = double(base::unit(id_hash)) / rate;
    return std::floor((time_s + phase) * rate) / rate - phase;
}

}  // namespace claque::animcache
