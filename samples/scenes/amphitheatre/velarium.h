// The awning (velarium): strips of dyed linen on ropes from the masts of the attic towards a ring of rope above the
// arena. Crews draw a strip out as far as the sun needs it: on the sun's side far in, on the other side hardly.
#pragma once

#include "samples/scenes/amphitheatre/plan.h"
#include "samples/scenes/amphitheatre/sun.h"

namespace scenes::amphitheatre
{

class Velarium
{
public:
    Velarium(const Plan &plan, const Daylight &light);

    // How far a strip reaches in from the masts, metres; strips are as wide as a bay and lie at its middle.
    double reach_of(int bay) const;
    // Of the cloth and of the ropes that carry it, metres above the arena.
    double height_at(double out) const;
    // The share of the sun that the awning lets through to a point below it: 1 in the open, dim below the cloth.
    double passes(Vec3 at) const;
    // The colour of a strip's linen.
    static Rgb dye_of(int bay);

    static constexpr double mast_m = 51.3;  // where the masts stand
    static constexpr double ring_m = -3;    // the ring of rope, inside the arena's wall
    static constexpr double through_linen = 0.28;

private:
    const Plan &plan_;
    Vec3 to_sun_;
};

}  // namespace scenes::amphitheatre
