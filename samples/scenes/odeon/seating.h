// The sitters of the audience: their seats, sizes and directions.
#pragma once

#include <claque/crowd.h>

#include "samples/scenes/odeon/theatre.h"

namespace scenes
{

struct Sitter {
    size_t seat = 0;          // of seats_of()
    size_t social_class = 0;  // of Theatre::classes
    float scale = 1;
    clq_transform place = {};
};

// Fills the rows of each class, row by row; empty seats are picked at random. count 0: the description's numbers;
// other counts are distributed in its proportions. Throws Failure if a class has too few seats.
std::vector<Sitter> seat_people(const Theatre &theatre, const std::vector<Seat> &seats, uint32_t count, uint64_t seed);

// A turn away from the seat's direction, in degrees, in [-facing_noise_deg, facing_noise_deg]: Perlin noise over the
// plan, so that neighbours turn alike, but not quite (S1 2).
double facing_turn_deg(const Theatre &theatre, const Seat &seat, uint64_t seed);

// Sits a person of this scale on a seat, turned about the hips.
clq_transform sit_down(const Seat &seat, double turn_deg, float scale);

}  // namespace scenes
