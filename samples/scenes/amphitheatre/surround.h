// What stands round the rows: the podium and its gates and boxes of honour, the gallery and its columns, the attic with
// its masts, and the front of arches outside.
#pragma once

#include "samples/scenes/amphitheatre/masonry.h"

namespace scenes::amphitheatre
{

constexpr double box_floor_m = podium_m + 0.75;  // of the boxes of honour
constexpr double box_deep_m = 4.2;

void build_podium(Masonry &masonry, const Plan &plan);
void build_gallery(Masonry &masonry, const Plan &plan);
void build_masts(Masonry &masonry, const Plan &plan);

// The outer wall, one repeat of its picture a bay and the whole height.
Geometry outer_wall(const Plan &plan, const Exposure &exposure);

}  // namespace scenes::amphitheatre
