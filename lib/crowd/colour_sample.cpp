#include "lib/crowd/colour_sample.h"

#include <algorithm>
#include <cmath>

#include "lib/base/hash.h"
#include "lib/math/hsb.h"

namespace claque::crowd
{

namespace
{

constexpr uint64_t first_variation_index = 1 << 16;  // of picks: palette entries use the lower indices, one per zone

double unit(uint64_t crowd_seed, uint64_t seed, base::Purpose purpose, uint64_t index)
{
    return double(base::unit(base::hash(crowd_seed, seed, purpose, index)));
}

}  // namespace

ColourSample::ColourSample(uint64_t crowd_seed, uint64_t seed, uint32_t zone)
    : entry(unit(crowd_seed, seed, base::Purpose::pick, zone)),
      hsb{unit(crowd_seed, seed, base::Purpose::hue, zone), unit(crowd_seed, seed, base::Purpose::saturation, zone),
          unit(crowd_seed, seed, base::Purpose::brightness, zone)}
{
}

void ColourSample::vary(uint64_t crowd_seed, uint64_t seed, uint32_t zone, double variation)
{
    constexpr double last = 1 - 1.0 / (1 << 24);
    double *const all[] = {&entry, hsb, hsb + 1, hsb + 2};
    for (uint32_t i = 0; i < 4; ++i) {
        const double by =
            variation *
            (2 * unit(crowd_seed, seed, base::Purpose::pick, first_variation_index + uint64_t(zone) * 4 + i) - 1);
        const double to = std::fabs(*all[i] + by);
        *all[i] = std::min(to > 1 ? 2 - to : to, last);
    }
}

Hsb ColourSample::in(const model::HsbRange &range) const
{
    const auto between = [](float first, float last, double u) {
        return double(first) + u * (double(last) - double(first));
    };
    return {math::lerp_hue(double(range.hue_min_deg), double(range.hue_max_deg), hsb[0]),
            between(range.saturation_min, range.saturation_max, hsb[1]),
            between(range.brightness_min, range.brightness_max, hsb[2])};
}

}  // namespace claque::crowd
