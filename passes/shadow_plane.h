// Where the shadow of one individual falls: a plane and a light as its eye sees them. The matrix is the usual one of planar
// shadows (Blinn 1988): each point goes along its ray to the plane.
#pragma once

#include "lib/draw/draw_list.h"
#include "passes/shadow.h"

#include <glm/vec3.hpp>

namespace claque::passes
{

struct ShadowPlane {
    glm::dvec3 normal = glm::dvec3(0, 1, 0);  // unit, in eye space; normal * p == offset on the plane
    double offset = 0;
    glm::dvec3 light = glm::dvec3(0, 1, 0);  // the direction to it, or its place
    bool parallel = true;

    double above(const glm::dvec3 &p) const { return glm::dot(normal, p) - offset; }
    // Of a point that the light is above.
    glm::dvec3 project(const glm::dvec3 &p) const;
};

// Of one list under one light.
class ShadowPlaneFinder
{
public:
    ShadowPlaneFinder(const ShadowOptions &options, const draw::DrawList &list);

    // False where nothing falls: the eye is below the ground, the light is not above the ground, or, where it has a place,
    // the individual's sphere reaches up to it; or the host says that there is no ground.
    bool find(const draw::Item &item, ShadowPlane &plane) const;

private:
    double height_of(const draw::Item &item) const;

    const ShadowOptions &options_;
    glm::dvec3 up_, light_;  // in eye space
    double eye_height_;
};

// Vertices of one individual to their shadow, in eye space.
class Flattener
{
public:
    Flattener(const ShadowPlane &plane, const float *model_view, const draw::Vertices &vertices);
    // The same for vertices that `local` brings into the individual's space.
    Flattener(const ShadowPlane &plane, const float *model_view, const math::Affine &local);

    void operator()(float x, float y, float z, float *out) const;
    // Column-major, as GL takes it. Of parallel light.
    void store(float *out) const;

private:
    void project();

    ShadowPlane plane_;
    double columns_[4][3];  // to eye space; where light is parallel, on to the plane
};

}  // namespace claque::passes
