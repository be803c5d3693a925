// How much light reaches a point of the amphitheatre: the sun, past the outer wall and the awning, and the sky. The
// light of stone is computed once, since the sun of a scene stands still.
#pragma once

#include "samples/scenes/amphitheatre/velarium.h"

namespace scenes::amphitheatre
{

class Exposure
{
public:
    Exposure(const Plan &plan, const Velarium &velarium, const Daylight &light);

    const Daylight &light() const { return light_; }
    // The share of the sun that reaches a point, [0, 1].
    double sun_at(Vec3 at) const;
    // Light on a surface: open is the share of the sky above it that it sees, [0, 1].
    Rgb on(Vec3 at, Vec3 normal, double open) const;
    // The same without asking what is in the sun's way.
    Rgb with(double sun, Vec3 normal, double open) const;
    // The brightness of a person there, against one in the open.
    double of_person(Vec3 head) const;

private:
    const Plan &plan_;
    const Velarium &velarium_;
    Daylight light_;
};

Rgb operator*(Rgb a, Rgb b);

}  // namespace scenes::amphitheatre
