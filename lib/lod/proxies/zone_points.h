// Points of the source that show each zone. Internal to lib/lod/proxies.
#pragma once

#include <optional>

#include "lib/lod/surface/point_tree.h"
#include "lib/lod/surface/surface_samples.h"

namespace claque::lod
{

struct ZonePoints {
    std::vector<SurfacePoint> points;
    std::optional<PointTree> nearest;  // of `points`; none: no point shows the zone
};

// [zones, and one for no zone] of a character at rest in a texture set; null: its own images.
std::vector<ZonePoints> zone_points_of(const model::Model &model, const PosedParts &fine, const model::TextureSet *set);

}  // namespace claque::lod
