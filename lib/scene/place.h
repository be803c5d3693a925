// Where individuals are at a time, exactly, and bounds of that for the index. The place of an individual is its
// Skeleton Root without the ground: its Reference Point, moved along its track or in its group, and its root path.
#pragma once

#include "lib/crowd/crowd.h"
#include "lib/scene/tree.h"

namespace claque::scene
{

// The place alone. False: the individual is absent at that time, or its place is not finite.
bool place_at(const crowd::Crowd &crowd, uint32_t row, double time_s, glm::dvec3 &out) noexcept;

// The sphere that holds the individual in every pose, on any ground.
struct Body {
    glm::dvec3 place = glm::dvec3(0), centre = glm::dvec3(0);
    double radius = 0;
};
bool body_at(const crowd::Crowd &crowd, uint32_t row, double time_s, Body &out) noexcept;

// A leaf that holds the place for as long as the individual is not changed, from time_s - valid_s to time_s + valid_s.
// Within `speed` times the time beyond, it holds it at any other time.
struct Bounds {
    Leaf leaf;
    Box tight;  // of the place at time_s, with the root path
    double valid_s = 0;
};
// False: the place is not finite, so that no question finds the individual.
//   spare   world units by which the box of what moves by itself is larger than it has to be
bool bounds_at(const crowd::Crowd &crowd, uint32_t row, double time_s, double spare, Bounds &out) noexcept;

}  // namespace claque::scene
