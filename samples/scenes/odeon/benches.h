// The seats of a theatre as people fill them: each row between two gangways is two benches, one for each gangway.
// People fill a bench from its end to its gangway and empty it the other way round, so they pass before no knees.
#pragma once

#include <array>
#include <string>

#include "samples/scenes/odeon/theatre.h"

namespace scenes
{

struct Bench {
    size_t row = 0;
    std::string social_class;
    std::vector<size_t> seats;      // of seats_of(), from the end of the bench to its gangway
    std::array<double, 3> entry{};  // in the gangway, beside the row
    double gangway_deg = 0;
    double climb_m = 0;  // along the stairs, from the orchestra
};

// Of all rows that belong to a class; seats that no gangway leads to are left out.
std::vector<Bench> benches_of(const Theatre &theatre, const std::vector<Seat> &seats);

}  // namespace scenes
