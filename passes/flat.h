// Levels of few triangles in a colour a triangle. GL_FLAT shows the colour of a triangle's last vertex, its provoking vertex,
// on all of it, lit by its normal: so zones share their vertices, where smooth shading and texture coordinates would have each stand once
// for every zone it borders on. Where each triangle shows one texel, the colour can hold that too, and no texture is sampled.
// Of llvmpipe's work for people of 14 to 60 triangles that leaves less than half of the vertices, and pixels without an
// interpolation or a fetch.
#pragma once

#include "passes/prepared.h"

namespace claque::passes
{

// Fills out.flat, of a batched level that shows_texels() (places.h), `most` triangles at most; of any other it
// stays empty. Throws std::bad_alloc.
void prepare_flat(PreparedLevel &out, const model::Template &source, const model::Level &level, uint32_t max_triangles);

}  // namespace claque::passes
