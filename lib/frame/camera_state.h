// A view's camera, prepared once for all steps of an update.
#pragma once

#include "lib/frame/view.h"
#include "lib/math/rough_sphere.h"

namespace claque::frame
{

// An eye, prepared for many individuals. Positions are in world axes relative to the eye.
struct CameraState {
    explicit CameraState(const View &view);
    bool casts() const { return shadow != glm::dvec3(0); }  // whether its picture shows shadows
    glm::dvec3 eye;
    glm::dmat3 world_to_eye;
    math::Frustum frustum;
    glm::dvec3 shadow;
    math::RoughFrustum rough;  // with the shadow, in the world
    double distance_scale;     // effective distance per distance (S0 5)
    // lower bound of effective distances: the fixed one of a parallel projection, which has no distance
    double min_distance;
};

}  // namespace claque::frame
