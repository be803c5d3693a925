// Levels without zones: every triangle once, by source vertices. Close textures need no zones, because they have the
// colours of zones in them; nor do individuals whose zones all have one colour.
#pragma once

#include "passes/prepared.h"

namespace claque::passes
{

// Leaves the level without one if its individuals are drawn in batches, which have no dirty triangles.
void prepare_plain(PreparedLevel &out, const model::Level &level);

// True if all zones of a template have one colour. `zone_rgb`: 3 bytes for each.
bool one_colour(const PreparedTemplate &prepared, const uint8_t *zone_rgb);

}  // namespace claque::passes
