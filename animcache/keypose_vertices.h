// The vertices of one individual that shows two key-poses (S3 4). The steps are the same whether its key-poses are kept
// or made for this update, so that keeping does not change the picture.
#pragma once

#include "animcache/evaluate.h"

namespace claque::animcache
{

// requires request.key_pose.mode == KeyPoseMode::interpolated
//   vertices   [vertex_floats of the level]; scratch with `vertices`
void interpolate(const Request &request, VertexFormat vertex_format, const Scratch &scratch, float *vertices);

// Blends from a to b by `blend`; normals are not renormalised. out may be a or b.
//   each [vertex_floats of the level]
void blend_vertices(const model::Level &level, VertexFormat vertex_format, const float *a, const float *b, float blend,
                    float *out);

}  // namespace claque::animcache
