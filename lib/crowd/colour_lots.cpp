#include "lib/crowd/colour_lots.h"

#include <algorithm>
#include <cmath>

#include "lib/base/hash.h"
#include "lib/math/hsb.h"

namespace claque::crowd
{

namespace
{

constexpr uint64_t apart_from = 1 << 16;  // of picks: below are dyes, one a zone

double unit(uint64_t crowd_seed, uint64_t seed, base::Purpose purpose, uint64_t index)
{
    return double(base::unit(base::hash(crowd_seed, seed, purpose, index)));
}

}  // namespace

ColourLots::ColourLots(uint64_t crowd_seed, uint64_t seed, uint32_t zone)
    : dye(unit(crowd_seed, seed, base::Purpose::pick, zone)),
      place{unit(crowd_seed, seed, base::Purpose::hue, zone), unit(crowd_seed, seed, base::Purpose::saturation, zone),
            unit(crowd_seed, seed, base::Purpose::brightness, zone)}
{
}

void ColourLots::move(uint64_t crowd_seed, uint64_t seed, uint32_t zone, double apart)
{
    constexpr double last = 1 - 1.0 / (1 << 24);
    double *const all[] = {&dye, place, place + 1, place + 2};
    for (uint32_t i = 0; i < 4; ++i) {
        const double by =
            apart * (2 * unit(crowd_seed, seed, base::Purpose::pick, apart_from + uint64_t(zone) * 4 + i) - 1);
        const double to = std::fabs(*all[i] + by);
        *all[i] = std::min(to > 1 ? 2 - to : to, last);
    }
}

Hsb ColourLots::in(const model::HsbRange &range) const
{
    const auto between = [](float first, float last, double u) {
        return double(first) + u * (double(last) - double(first));
    };
    return {math::hue_in(double(range.hue_first_deg), double(range.hue_last_deg), place[0]),
            between(range.saturation_first, range.saturation_last, place[1]),
            between(range.brightness_first, range.brightness_last, place[2])};
}

}  // namespace claque::crowd
