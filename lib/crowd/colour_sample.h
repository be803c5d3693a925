// The lots that one zone of one individual draws: which of its dyes, and where in that one's range.
#pragma once

#include "lib/crowd/oklab_sampler.h"

namespace claque::crowd
{

struct ColourSample {
    // Hashes of (seed of the crowd, of the individual, purpose, zone), nothing else.
    ColourSample(uint64_t crowd_seed, uint64_t seed, uint32_t zone);

    // Each away from where it is, by lots of this zone, by `apart` at most. They bounce off the ends of [0, 1), so that they
    // stay uniform: with 1 nothing is left of where they were.
    void vary(uint64_t crowd_seed, uint64_t seed, uint32_t zone, double variation);

    Hsb in(const model::HsbRange &range) const;  // uniform in HSB

    double entry;   // [0, 1)
    double hsb[3];  // hue, saturation, brightness, each [0, 1)
};

}  // namespace claque::crowd
