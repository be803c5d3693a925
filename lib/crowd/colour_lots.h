// The lots that one zone of one individual draws: which of its dyes, and where in that one's range.
#pragma once

#include "lib/crowd/perceived.h"

namespace claque::crowd
{

struct ColourLots {
    // Hashes of (seed of the crowd, of the individual, purpose, zone), nothing else.
    ColourLots(uint64_t crowd_seed, uint64_t seed, uint32_t zone);

    // Each away from where it is, by lots of this zone, by `apart` at most. They bounce off the ends of [0, 1), so that they
    // stay uniform: with 1 nothing is left of where they were.
    void move(uint64_t crowd_seed, uint64_t seed, uint32_t zone, double apart);

    Hsb in(const model::HsbRange &range) const;  // uniform in HSB

    double dye;       // [0, 1)
    double place[3];  // hue, saturation, brightness, each [0, 1)
};

}  // namespace claque::crowd
