// Vertices of a level that lie and move as one: those that stand twice for what they show or how they are lit alone.
#pragma once

#include "lib/model/template.h"

#include <vector>

namespace claque::passes
{

// Whether a level is one surface whose triangles are all clean, `most` at most, each with one place in the texture for all
// three corners.
bool shows_texels(const model::Level &level, uint32_t max_triangles);

// For each source vertex the first one with its position and influences. Where a level has morph targets each stands for
// itself.
std::vector<uint32_t> welded_vertices(const model::Level &level);

}  // namespace claque::passes
