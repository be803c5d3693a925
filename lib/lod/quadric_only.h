// Decimation by OpenMesh's quadric alone, on the parts welded by position: the baseline for comparison. Seams, borders,
// zones, influences and textures cost nothing and are not kept. Internal to lib/lod.
#pragma once

#include "lib/lod/decimate.h"

namespace claque::lod
{

// Like decimate: one level for each target, descending, finest first. When a vertex moves onto another, each face
// corner takes the corner of its own part there with the nearest texture coordinates; without one, it takes only the
// position. Throws base::Error (CLQ_ARGUMENT) if there are no triangles or no targets. Deterministic.
std::vector<Decimated> decimate_quadric_only(const std::vector<SourcePart> &parts, const std::vector<size_t> &targets);

}  // namespace claque::lod
