// Finds where people come close to each other as they pass, from the points that their tracks are made of.
#pragma once

#include "lib/track/build.h"

namespace claque::track
{

struct FoundPassing {
    uint32_t person = 0;
    Passing passing;
};

// Passings of people who come within a metre of each other and move against each other by 0.6 m/s or more, each for
// both, by person, then by time. The time for it grows with n log n of the points' seconds, and with the number of
// people within a metre. Throws base::Error (ARGUMENT: points that a track cannot have) or std::bad_alloc.
//   people            [the points of each]; times ascend
//   metres_per_unit   of the world
void find_passings(base::Span<const base::Span<const Point>> people, double metres_per_unit, Array<FoundPassing> &out);

}  // namespace claque::track
