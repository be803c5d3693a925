// Transforms from an actor's space to an eye's. They are double until the eye is subtracted, so that a world of 10^6 m
// does not jitter.
#pragma once

#include <glm/gtc/quaternion.hpp>
#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

namespace claque::math
{

// The rotation of a quaternion of about unit length; columns are the rotated axes.
glm::dmat3 rotation_of(const glm::quat &q);

// From actor space to eye space: a rotation times one factor, and an origin.
struct EyeTransform {
    glm::dmat3 axes = glm::dmat3(1);
    glm::dvec3 origin = glm::dvec3(0);
};

// For an actor at `position`, rotated and scaled (a negative scale mirrors).
EyeTransform eye_transform(const glm::dmat3 &world_to_eye, const glm::dvec3 &eye, const glm::dvec3 &position,
                           const glm::quat &orientation, double scale);

// Column-major for glLoadMatrixf.
void store_matrix(const EyeTransform &place, float out[16]);

}  // namespace claque::math
