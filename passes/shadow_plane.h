// The shadow of one individual: a plane and a light in eye space. The matrix is that of planar shadows (Blinn 1988):
// each point moves along its ray to the plane.
#pragma once

#include <glm/vec3.hpp>

#include "lib/base/host_call.h"
#include "lib/draw/draw_list.h"
#include "passes/shadow.h"

namespace claque::passes
{

struct ShadowPlane {
    glm::dvec3 normal = glm::dvec3(0, 1, 0);  // unit, in eye space; normal * p == offset on the plane
    double offset = 0;
    glm::dvec3 light = glm::dvec3(0, 1, 0);  // the direction to the light, or its position
    bool parallel = true;

    double above(const glm::dvec3 &p) const { return glm::dot(normal, p) - offset; }
    // Requires the light to be above the point.
    glm::dvec3 project(const glm::dvec3 &p) const;
};

// For one list under one light.
class ShadowPlaneFinder
{
public:
    ShadowPlaneFinder(const ShadowOptions &options, const draw::DrawList &list);

    // False if there is no shadow: the eye is below the ground, the light is not above it or is a positioned light
    // within the height of the individual's sphere, or the host says that there is no ground.
    bool find(const draw::Item &item, ShadowPlane &plane);

    // The first exception of the host's height function, after which no individual has a shadow.
    const base::Status &status() const { return host_calls_.status(); }

private:
    double height_of(const draw::Item &item);

    const ShadowOptions &options_;
    glm::dvec3 up_, light_;  // in eye space
    double eye_height_;
    base::HostCalls host_calls_;
};

// Projects vertices of one individual to their shadow in eye space.
class Flattener
{
public:
    Flattener(const ShadowPlane &plane, const float *model_view, const draw::Vertices &vertices);
    // For vertices that `local` transforms to the individual's space.
    Flattener(const ShadowPlane &plane, const float *model_view, const math::Affine &local);

    void operator()(float x, float y, float z, float *out) const;
    // Column-major for GL; requires parallel light.
    void store(float *out) const;

private:
    void project();

    ShadowPlane plane_;
    double columns_[4][3];  // to eye space; for parallel light on to the plane
};

}  // namespace claque::passes
