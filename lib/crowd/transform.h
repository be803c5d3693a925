// A transform: position, rotation and one scale. Groups are spaces in which actors have transforms.
#pragma once

#include <glm/gtc/quaternion.hpp>
#include <glm/vec3.hpp>

namespace claque::crowd
{

struct Transform {
    glm::dvec3 position = glm::dvec3(0);            // of the Reference Point
    glm::quat orientation = glm::quat(1, 0, 0, 0);  // unit within 0.001
    float scale = 1;                                // finite, not 0; negative mirrors
};

// Returns it, or throws base::Error (CLQ_ARGUMENT) naming the broken rule and the number.
Transform checked(const Transform &transform);

// The world transform of an object with `inner` in the space of `outer`. A negative scale mirrors through the point, so
// it commutes with every rotation.
Transform composed(const Transform &outer, const Transform &inner);
glm::dvec3 composed_position(const Transform &outer, const glm::dvec3 &inner);

// The transform in the space of `outer` of an object with `world`: composed(outer, relative(outer, world)) is world.
Transform relative(const Transform &outer, const Transform &world);

}  // namespace claque::crowd
