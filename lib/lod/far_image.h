// What triangles of far levels show. Between the files of this room only.
#pragma once

#include "lib/lod/far.h"

namespace claque::lod
{

// Gives each triangle of each part its zone and brightness, from all of the source that lies nearest to it, and the
// parts their texture coordinates.
FarLevels painted(const model::Model &model, const std::vector<const model::Part *> &source,
                  std::vector<model::Part> parts);

}  // namespace claque::lod
