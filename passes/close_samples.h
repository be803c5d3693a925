// Points of a level's surface as pictures from several sides show them: as many as their triangles have pixels.
#pragma once

#include <vector>

#include <glm/vec2.hpp>

#include "lib/model/template.h"

namespace claque::passes
{

struct CloseSample {
    uint32_t texture = 0;
    glm::dvec2 uv = glm::dvec2(0);
    glm::dvec2 across = glm::dvec2(0), up = glm::dvec2(0);  // how uv changes per metre of the picture's plane
};

std::vector<CloseSample> close_samples(const model::Level &level);

}  // namespace claque::passes
