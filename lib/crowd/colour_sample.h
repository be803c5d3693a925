// The random numbers of one zone of one individual: which palette entry, and where in its colour range.
#pragma once

#include "lib/crowd/oklab_sampler.h"

namespace claque::crowd
{

struct ColourSample {
    // Hashes of (crowd seed, individual seed, purpose, zone) only.
    ColourSample(uint64_t crowd_seed, uint64_t seed, uint32_t zone);

    // Moves each number by a random amount of this zone, by `variation` at most. Numbers are reflected at the ends of
    // [0, 1), so that they stay uniform; a variation of 1 makes them independent of their former values.
    void vary(uint64_t crowd_seed, uint64_t seed, uint32_t zone, double variation);

    Hsb in(const model::HsbRange &range) const;  // uniform in HSB

    double entry;   // [0, 1)
    double hsb[3];  // hue, saturation, brightness, each [0, 1)
};

}  // namespace claque::crowd
