// From an actor's space to an eye's, in double until the eye has been taken off: a world of 10^6 m does not shake.
#pragma once

#include <glm/gtc/quaternion.hpp>
#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

namespace claque::math
{

// Rotation of a quaternion that need not be quite unit; columns are the turned axes.
glm::dmat3 rotation_of(const glm::quat &q);

// A rotation times one factor, and a place: actor's space to eye space.
struct EyeTransform {
    glm::dmat3 axes = glm::dmat3(1);
    glm::dvec3 origin = glm::dvec3(0);
};

// An actor at `position`, turned and scaled (a negative scale mirrors), seen by an eye.
EyeTransform eye_transform(const glm::dmat3 &world_to_eye, const glm::dvec3 &eye, const glm::dvec3 &position,
                           const glm::quat &orientation, double scale);

// Column-major for glLoadMatrixf.
void store_matrix(const EyeTransform &place, float out[16]);

}  // namespace claque::math
