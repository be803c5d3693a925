// What all steps of an update ask of a view's camera, found once.
#pragma once

#include "lib/frame/view.h"
#include "lib/math/frustum.h"

namespace claque::frame
{

// An eye, ready for many individuals. Positions are in world axes relative to the eye.
struct CameraState {
    explicit CameraState(const View &view);
    glm::dvec3 eye;
    glm::dmat3 world_to_eye;
    math::Frustum frustum;
    glm::dvec3 shadow;
    double distance_scale;  // times a distance: its effective distance (S0 5)
    double min_distance;    // no effective distance is less: that of a parallel projection, which knows no distance
};

}  // namespace claque::frame
