// An oval of four arcs, and the curves parallel to it: the plan of an amphitheatre. Its x axis is the long one, z the
// short one, and the origin its middle. A place on the plan is a turn and a distance: the turn is the direction of the
// normal (0 along +x, a quarter along +z, radians), the distance is measured outwards from the oval along it, metres.
#pragma once

namespace scenes::amphitheatre
{

struct Spot {
    double x = 0, z = 0;
    double out_x = 1, out_z = 0;  // the normal, outwards
};

struct Bearing {
    double turn = 0, out = 0;
};

class Oval
{
public:
    // Half the axes. The centres of the arcs form triangles of sides 3, 4 and 5, as in Roman plans.
    Oval(double half_long, double half_short);

    Spot at(double turn, double out) const;
    Bearing bearing(double x, double z) const;  // the inverse, for points outside the four centres' diamond

    double radius(double turn, double out) const;  // of the arc there
    // Along the curve at a distance, from turn 0; negative turns give negative lengths.
    double length(double turn, double out) const;
    double turn_at(double length, double out) const;
    double perimeter(double out) const;

private:
    double end_centre_, end_radius_;    // on the x axis
    double side_centre_, side_radius_;  // on the z axis, beyond the middle
    double corner_;                     // the turn at which an end arc becomes a side arc
};

}  // namespace scenes::amphitheatre
