// The two kinds of root paths (S0 3).
#pragma once

#include "lib/behave/behave.h"

namespace claque::behave
{

// A flight: a closed uniform Catmull-Rom curve through all positions. The actor faces along it and banks into turns.
crowd::Transform flight_transform(const crowd::RootPath &path, double round_s) noexcept;
RootSpeed flight_speed(const crowd::RootPath &path, double round_s) noexcept;
// An upper bound of the distance of its farthest point, from the control points of its Bezier segments.
double flight_reach(const crowd::RootPath &path);

// A key-framing table: linear positions between keys, rotations along the shorter arc.
crowd::Transform table_transform(const crowd::RootPath &path, double round_s) noexcept;
RootSpeed table_speed(const crowd::RootPath &path, double round_s) noexcept;

}  // namespace claque::behave
