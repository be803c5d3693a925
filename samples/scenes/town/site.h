// A building's own axes, and the few kinds of faces that buildings consist of. `along` runs to the right of a viewer
// before the front, `out` from the front to that viewer; y is up.
#pragma once

#include <initializer_list>

#include "samples/scenes/geometry.h"
#include "samples/scenes/town/pictures.h"
#include "samples/scenes/town/plan.h"

namespace scenes::town
{

// The rotation of a site: `out` is of unit length.
class Site
{
public:
    Site(Point at, Point out) : at_(at), out_(out) {}

    Vec3 at(double along, double y, double out) const;
    Point ground(double along, double out) const;
    Point out() const { return out_; }
    Point along() const { return {out_.z, -out_.x}; }

    // Three or four corners (along, y, out), counter-clockwise from outside. The picture is upright on the face, with
    // v = 0 at the first corner and `metres` a repeat.
    void face(Geometry &g, std::initializer_list<Vec3> corners, Rgb colour, float metres) const;
    // From `left` to `right`, points (along, out) as seen from outside, between two heights at either end.
    struct Upright {
        double left_along, left_out, right_along, right_out;
    };
    // whole_m: the height of the whole picture, of which the upper part shows; 0: all of it, stretched.
    void bay(Geometry &g, const Upright &wall, double left_low, double right_low, double high, Bay bay, Rgb colour,
             double whole_m = 0) const;
    // Without a bottom.
    void box(Geometry &g, Vec3 first, Vec3 last, Rgb colour, float metres) const;

private:
    Point at_, out_;
};

// The rectangle of a bay in the picture of facades.
struct BayBox {
    float u0, v0, u1, v1;
};
BayBox box_of(Bay bay);

}  // namespace scenes::town
