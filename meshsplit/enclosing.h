// A small sphere that encloses many.
#pragma once

#include "lib/model/template.h"

namespace claque::meshsplit
{

struct Ball {
    glm::dvec3 centre = glm::dvec3(0);
    double radius = 0;
};

// Encloses all balls, with a margin for float rounding; within a few per cent of the smallest such sphere. `balls` is
// not empty.
model::Sphere enclosing(const std::vector<Ball> &balls);

}  // namespace claque::meshsplit
