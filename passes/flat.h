// Prepares levels with few triangles for GL_FLAT. GL_FLAT gives a triangle the colour of its last vertex, the provoking
// vertex, lit by that vertex's normal. Zones then share vertices; smooth shading and texture coordinates need one copy
// for every zone at a vertex. If each triangle shows one texel, the colour includes the texel and no texture is
// sampled. For characters of 14 to 60 triangles llvmpipe then processes less than half of the vertices, and its pixels
// need no interpolation and no texture fetch.
#pragma once

#include "passes/prepared.h"

namespace claque::passes
{

// Fills out.flat for a batched level with shows_texels() (welded.h) and at most `max_triangles` triangles, which does
// not emit, as its texels would then multiply light alone; for any other level it stays empty. Throws std::bad_alloc.
void prepare_flat(PreparedLevel &out, const model::Template &source, const model::Level &level, uint32_t max_triangles);

}  // namespace claque::passes
