// Bilinear filtering where it mixes no zones. Clean triangles whose samples all use four texels of one zone are drawn
// with a linearly filtered copy of their texture, all others with the one that is sampled GL_NEAREST. A surface takes
// two draws.
#pragma once

#include "passes/prepared.h"

namespace claque::passes
{

// Makes out.filtered and out.linear from a level, unless no triangle can be filtered. Throws std::bad_alloc.
void prepare_linear_clean(PreparedLevel &out, const model::Template &source, const model::Level &level,
                          LuminanceStep &step);

}  // namespace claque::passes
