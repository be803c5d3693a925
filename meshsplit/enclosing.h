// A small sphere round many.
#pragma once

#include "lib/model/template.h"

namespace claque::meshsplit
{

struct Ball {
    glm::dvec3 centre = glm::dvec3(0);
    double radius = 0;
};

// Holds them all, with room for what arithmetic in float may add; within a few percent of the smallest that does.
// `balls` is not empty.
model::Sphere enclosing(const std::vector<Ball> &balls);

}  // namespace claque::meshsplit
