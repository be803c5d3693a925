// A hall of 16 m with one opening, through which everybody leaves.
#pragma once

#include "samples/halls/crowd.h"

namespace halls
{

struct Door {
    double width_m;
    size_t people;
    // Demands (docs/navigation.md): people a second and metre, and the longest pause between two of them.
    double least, most, longest_pause_s;
};
extern const Door doors[5];

struct Passage {
    double flow = 0;  // people a second and metre, while more than 2 a square metre wait within 2 m of the opening
    double longest_pause_s = 0, nearest_m = 0;
    size_t left = 0;  // in the hall after 300 s
};
Passage through_a_door(double width_m, size_t count, const Trial &trial);

// `count` people on each side of the opening walk to the other side.
struct Meeting {
    double last_s = 0, nearest_m = 0;
    size_t left = 0;  // after 300 s
};
Meeting meet_at_a_door(double width_m, size_t count, const Trial &trial);

struct Opening {
    double width_m;
    size_t count;  // on each side
};
extern const Opening openings[6];

// The hall, without what fills the opening.
Floor hall_with_opening(double width_m);

}  // namespace halls
