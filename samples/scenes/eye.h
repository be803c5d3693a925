// A clq_camera as the matrices that GL takes, for what a scene draws itself.
#pragma once

#include <claque/view.h>

namespace scenes
{

struct Eye {
    double position[3];
    float rotation[16];  // world to eye, column-major, no translation: for objects at infinity, and for lights
    float view[16];      // the same with the eye's position in the world
    float projection[16];
};

Eye eye_of(const clq_camera &camera);

// Looks from one point to another; fov_y_deg is the whole angle. Throws Failure if one point is straight above the
// other.
clq_camera look(const double (&eye)[3], const double (&target)[3], double fov_y_deg, double aspect, double z_near,
                double z_far);

}  // namespace scenes
