// Where a foot finds room on uneven ground: people put a foot on one tread of a stair, not across its edge.
#pragma once

#include "lib/track/build.h"

namespace claque::track
{

// A place of the ball of a foot, metres from the track's origin.
struct Stance {
    double x = 0, z = 0, heading_rad = 0;
    double y = NAN;    // NaN: the ground is not known
    double slope = 0;  // of the ground, in the direction of the foot
};

class Footing
{
public:
    // `settings` outlives it.
    Footing(const BuildSettings &settings, const Locomotion &locomotion, const Track &track, int foot);

    // Moves a place along the heading by reach_m at most to where most of the sole lies at one height, and sets y.
    // `body_y`: height of the person. Throws base::Error (CALLBACK).
    void settle(Stance &stance, double body_y) const;
    // Where no one tells of the ground: it is as high as the person where its path comes by, near a sample.
    static void follow_path(const FinePath &path, uint32_t near, Stance &stance);

private:
    double height(double x, double z, double body_y) const;

    const BuildSettings &settings_;
    glm::dvec3 origin_m_;
    double metres_per_unit_, sole_m_, highest_m_;
};

}  // namespace claque::track
