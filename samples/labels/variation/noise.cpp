#include "samples/labels/variation/noise.h"

#include <algorithm>
#include <cmath>

#include "samples/labels/variation/chance.h"

namespace labels
{

void add_noise(std::vector<uint8_t> &rgb, double read, double shot, uint64_t seed, uint32_t sample)
{
    const uint64_t base = chance_bits(seed, sample, "sensor.noise");
    for (size_t i = 0; i < rgb.size(); ++i) {
        // The sum of four uniform numbers has a variance of a third.
        const uint64_t bits = chance_bits(base, static_cast<uint32_t>(i), "");
        double sum = -2;
        for (int shift = 0; shift < 64; shift += 16) sum += (static_cast<double>(bits >> shift & 0xffff) + 0.5) / 65536;
        const double value = static_cast<double>(rgb[i]);
        const double deviation = std::sqrt(read * read + shot * shot * value / 255);
        rgb[i] = static_cast<uint8_t>(std::clamp(value + deviation * sum * std::sqrt(3.0) + 0.5, 0.0, 255.0));
    }
}

}  // namespace labels
