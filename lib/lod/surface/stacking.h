// Refuses meshes whose triangles lie on one another in great numbers: rays and nearest points would test all of them
// for each of them, which takes the square of their number.
#pragma once

#include <string>

#include "lib/lod/surface/aabb_tree.h"

namespace claque::lod
{

// The most triangles in the boxes of a tree (aabb_tree.h) that hold the centre of a triangle, on average.
constexpr uint64_t max_stacking = 512;

// Throws base::Error (CLQ_LIMIT) that names the model and both numbers. Tests a small multiple of max_stacking boxes
// for each triangle.
void check_stacking(const std::vector<Corners3> &triangles, const std::string &model);

}  // namespace claque::lod
