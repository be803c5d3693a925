// Decimation as it comes: OpenMesh's quadric and nothing else, on the parts welded by position. Seams, borders, zones,
// influences and textures cost nothing and are not kept. What levels of detail are held against.
#pragma once

#include "lib/lod/decimate.h"

namespace claque::lod
{

// As decimate: one for each target, descending, finest first. Where a vertex is moved onto another, the corners of each face
// take what the vertices of its own part at that place have that lie nearest in the texture; where its part has none there,
// the place alone. Throws base::Error (CLQ_ARGUMENT) where there are no triangles or no targets. Deterministic.
std::vector<Decimated> decimate_quadric_only(const std::vector<SourcePart> &parts, const std::vector<size_t> &targets);

}  // namespace claque::lod
