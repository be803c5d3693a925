// A corridor that ends where it begins, in which people walk on and on.
#pragma once

#include "samples/halls/crowd.h"

namespace halls
{

struct Ring {
    double width_m;
    double inner_m = 10 - width_m / 2, outer_m = 10 + width_m / 2;
    double area_m2() const { return pi * (outer_m * outer_m - inner_m * inner_m); }
    Floor floor() const;
};

struct Round {
    double median_m_s = 0;  // of the last 20 of 60 s
    double order = 0;       // of lanes at the end
    double longest_stop_s = 0, nearest_m = 0;
};
// ways: 1; or 2, where every other person walks the other way round.
Round walked_round(double width_m, double people_per_m2, int ways, const Trial &trial);

}  // namespace halls
