// A camera that a person moves as in 3D programs: round a point, across, nearer, or on foot.
#pragma once

#include <claque/view.h>

#include <array>

namespace view
{

using Point = std::array<double, 3>;

struct FreeCamera {
    Point target = {0, 1, 0};  // what it turns round
    double distance_m = 10;
    double yaw_rad = 0, pitch_rad = -0.2;  // of the direction of view; pitch is negative downwards
    double fov_rad = 0.7;                  // the whole vertical angle
    double far_m = 2000;

    Point direction() const;
    Point eye() const;
    clq_camera camera(double aspect) const;

    // Movements of the mouse as shares of the picture's height.
    void orbit(double right, double down);
    void pan(double right, double down);
    // The eye comes nearer by a notch of the wheel, or goes back.
    void zoom(double notches);
    void walk(double right_m, double ahead_m);
    // Looks at a sphere from where it looks now, so that the sphere fills most of the picture.
    void frame(const Point &centre, double radius_m);
};

// What a camera of a scene shows. `depth_m`: the distance of what the new camera turns round.
FreeCamera free_camera_from(const clq_camera &camera, double depth_m);

// The distance from the eye to level ground, along the middle of the picture; `otherwise` where it meets none soon.
double depth_of_ground(const clq_camera &camera, double otherwise);

// From -1 to 1, right and up; false: behind the eye.
bool project(const clq_camera &camera, const Point &at, double &x, double &y);

}  // namespace view
