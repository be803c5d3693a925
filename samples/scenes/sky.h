// The distance: a sky that pales towards the horizon, and hills; or a plain backdrop.
#pragma once

#include "samples/scenes/eye.h"
#include "samples/scenes/geometry.h"

namespace scenes
{

class Sky
{
public:
    enum class Land { hills, studio };
    static constexpr Rgb backdrop = {0.72f, 0.74f, 0.76f};  // of the studio, at the horizon
    Sky(uint64_t seed, Land land);

    // Draw this after all that is opaque: it fills what is still empty of a cleared picture. ground_m: the extent from
    // the centre, each way, of level ground at height 0 that was drawn; the part of the sky that it hides is left out.
    // Leaves the view set, lighting on and fog off.
    void draw(const Gl &gl, const Eye &eye, double ground_m = 0) const;

private:
    void studio();

    static constexpr int sectors = 12;

    // One strip all round, from `low` to `high` above the horizon (sines), each a function of the side.
    template <class Low, class High>
    void strip(Low low, High high, Rgb low_colour, Rgb high_colour);

    Geometry below_[sectors], dome_[sectors];  // the part that level ground may hide, and the rest
};

}  // namespace scenes
