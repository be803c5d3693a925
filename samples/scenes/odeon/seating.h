// Who sits on which seat, how tall, and turned which way.
#pragma once

#include "samples/scenes/odeon/theatre.h"

#include <claque/crowd.h>

namespace scenes
{

struct Sitter {
    size_t seat = 0;          // of seats_of()
    size_t social_class = 0;  // of Theatre::classes
    float scale = 1;
    clq_transform place = {};
};

// Fills the rows of each class, row by row; which seats stay empty is drawn by lot. count 0: as many as the description
// says; others are shared out in its proportions. Throws Failure where a class has not that many seats.
std::vector<Sitter> seat_people(const Theatre &theatre, const std::vector<Seat> &seats, uint32_t count, uint64_t seed);

// A turn from where the seat faces, in degrees, in [-facing_noise_deg, facing_noise_deg]: Perlin noise over the plan, so
// that neighbours turn alike, but not quite (S1 2).
double facing_turn_deg(const Theatre &theatre, const Seat &seat, uint64_t seed);

// Sits a person of this scale on a seat, turned about the hips.
clq_transform sit_down(const Seat &seat, double turn_deg, float scale);

}  // namespace scenes
