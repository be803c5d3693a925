// The camera of `hundred_actors` and its frustum: the distances of spheres from the planes that bound it.
#pragma once

#include <claque/view.h>

#include <array>

#include "samples/scenes/hundred/piece_mesh.h"

namespace scenes::hundred
{

enum class Lies { outside, across, within };

// For pictures of 4 to 3, as in S0 7.2 (1024 x 768).
class Frustum
{
public:
    Frustum();

    static clq_camera camera(double aspect);
    static Point eye();

    // The point at these distances ahead of the eye, to the right, and up, in the camera's own axes.
    Point at(double ahead, double right, double up) const;
    // The point at a distance ahead, and at a distance outside the right (side 1) or left (side -1) plane.
    Point beside(double side, double ahead, double out, double up) const;
    // Outward normal of that plane.
    Point normal(double side) const;
    Point right() const { return right_; }

    // Tests against all planes. Wholly outside means outside one of them.
    Lies test(Point centre, double radius) const;
    // The largest distance outside any plane except the one on `side`; 0: all planes.
    double out_but(double side, Point centre) const;
    double reach(Point p) const;  // from the eye

private:
    Point ahead_, right_, up_;
    double tan_x_, tan_y_;
    std::array<Point, 4> normals_;  // right, left, top, bottom
};

}  // namespace scenes::hundred
