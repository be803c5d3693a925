// A part of a character that levels are made from. Internal to lib/lod.
#pragma once

#include <vector>

#include <glm/vec3.hpp>

#include "lib/model/model.h"

namespace claque::lod
{

// A part and the rest positions of its vertices in the space of all parts. In that space, distances are those on the
// character, whatever node a rigid part hangs on.
struct SourcePart {
    const model::Part *part = nullptr;
    const std::vector<glm::vec3> *rest = nullptr;  // [positions.size()]; null: the part's own positions
};

}  // namespace claque::lod
