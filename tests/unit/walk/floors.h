// Grounds that a test describes, and people on them.
#pragma once

#include <claque/navigation.h>

#include <array>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "samples/halls/floor.h"

namespace floors
{

using Point = std::array<double, 3>;

using halls::Floor;

// Two rooms of 8 by 6 m with a wall between and an opening of 1.2 m in its middle, at x 8 to 8.2; a door fills it.
Floor two_rooms(bool with_door);

struct Held {
    explicit Held(const Floor &floor, const clq_walkers_def *def = nullptr) : navigation(floor.make().release())
    {
        EXPECT_EQ(clq_walkers_create(navigation, def, &walkers), CLQ_OK) << clq_last_error();
    }
    ~Held()
    {
        clq_walkers_destroy(walkers);
        clq_navigation_destroy(navigation);
    }
    Held(const Held &) = delete;
    Held &operator=(const Held &) = delete;

    clq_walker add(double x, double z, const clq_locomotion *locomotion = nullptr,
                   float radius_m = clq_walker_def_init().radius_m) const;
    void go(clq_walker walker, double x, double z, float near_m = 0.3f) const;
    clq_walker_info info(clq_walker walker) const;
    uint64_t hash() const;
    void step(int count = 1) const;

    clq_navigation *navigation = nullptr;
    clq_walkers *walkers = nullptr;
};

inline double apart(const double *a, const double *b) { return std::hypot(a[0] - b[0], a[2] - b[2]); }

}  // namespace floors
