// What of a template can be drawn with textures of single individuals, and how.
#pragma once

#include "passes/prepared.h"

namespace claque::passes
{

// Fills all members named close. Left out are textures of more than RendererOptions::close_bytes, and those
// with triangles within half a texel of an edge that clamps: GL 1.1 filters its border colour into these. To be called
// last: levels in batches show none. Throws std::bad_alloc.
void prepare_close(PreparedTemplate &out, const RendererOptions &options);

}  // namespace claque::passes
