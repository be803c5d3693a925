// Welded vertices: vertices of a level with equal position and movement, which differ only in what they show or how
// they are lit.
#pragma once

#include <vector>

#include "lib/model/template.h"

namespace claque::passes
{

// True if a level is one surface of at most `max_triangles` clean triangles, each with one texture coordinate for all
// three corners.
bool shows_texels(const model::Level &level, uint32_t max_triangles);

// For each source vertex the first one with its position and influences. In a level with morph targets each vertex
// stands for itself.
std::vector<uint32_t> welded_vertices(const model::Level &level);

}  // namespace claque::passes
