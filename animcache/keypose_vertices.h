// The vertices of one individual that shows two key-poses (S3 4). The same steps whether its key-poses are kept or made for
// this once, so that what is kept never changes what is shown.
#pragma once

#include "animcache/evaluate.h"

namespace claque::animcache
{

// requires request.shared.method == Method::interpolated
//   vertices   [vertex_floats of the level]; scratch with `vertices`
void interpolate(const Request &request, VertexFormat vertex_format, const Scratch &scratch, float *vertices);

// From a to b, `blend` of the way; normals are not renormalised. out may be a or b.
//   each [vertex_floats of the level]
void blend_vertices(const model::Level &level, VertexFormat vertex_format, const float *a, const float *b, float blend,
                    float *out);

}  // namespace claque::animcache
