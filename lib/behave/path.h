// The two kinds of ways that a Skeleton Root goes (S0 3).
#pragma once

#include "lib/behave/behave.h"

namespace claque::behave
{

// A flight: a uniform Catmull-Rom curve through all positions, closed; it looks along it and banks into turns.
crowd::Transform flight_transform(const crowd::RootPath &path, double round_s) noexcept;
// How far its farthest point is, from above: the corners of its Bezier pieces.
double flight_reach(const crowd::RootPath &path);

// A table of keys, straight in between, turned by the shorter arc.
crowd::Transform table_transform(const crowd::RootPath &path, double round_s) noexcept;

}  // namespace claque::behave
