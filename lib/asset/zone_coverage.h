// Finds the texels of an image that triangles show.
#pragma once

#include <cstdint>
#include <vector>

#include "lib/model/model.h"

namespace claque::asset
{

// Returns 1 for each texel whose centre lies in a triangle that shows the image, or that contains a corner of one; else
// 0. Time grows with the rows that triangles cover, not with their texels. Throws base::Error (CLQ_LIMIT) if these are
// more than a multiple of the triangles and texels.
std::vector<uint8_t> covered_texels(const model::Model &model, uint32_t image);

}  // namespace claque::asset
