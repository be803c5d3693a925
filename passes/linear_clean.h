// Bilinear filtering where it mixes nothing: clean triangles whose every sample takes four texels of one zone are drawn from a
// linearly filtered copy of their texture, all others from the one that is sampled GL_NEAREST. Two draws a surface.
#pragma once

#include "passes/prepared.h"

namespace claque::passes
{

// Makes out.smoothed and out.linear from a level, unless nothing of it can be filtered. Throws std::bad_alloc.
void prepare_linear_clean(PreparedLevel &out, const model::Template &source, const model::Level &level,
                          LuminanceStep &step);

}  // namespace claque::passes
