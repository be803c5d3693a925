// The stairs of a theatre, for those who build them and for those who walk on them.
#pragma once

#include <algorithm>

#include "samples/scenes/odeon/theatre.h"

namespace scenes
{

constexpr double stair_run_m = 0.27, stair_rise_m = 0.22;  // of the steps before a podium

// The start of the stone before a row's seats: at the previous row, at a walkway, or at the orchestra.
inline double front_of(const Theatre &theatre, size_t row)
{
    const std::vector<SeatRow> &rows = theatre.rows;
    double front = row == 0 ? theatre.orchestra_radius_m : rows[row - 1].radius_m + rows[row - 1].depth_m;
    for (const Walkway &walkway : theatre.walkways)
        if (walkway.inner_m < rows[row].radius_m) front = std::max(front, walkway.outer_m);
    return front;
}

// The level in front of that stone.
inline double floor_before(const Theatre &theatre, size_t row)
{
    double y = 0;
    for (const Walkway &walkway : theatre.walkways)
        if (walkway.inner_m < theatre.rows[row].radius_m) y = walkway.y_m;
    return y;
}

inline int climbing_steps(double from_y, double to_y)
{
    return std::max(1, static_cast<int>((to_y - from_y) / stair_rise_m + 0.999));
}

}  // namespace scenes
