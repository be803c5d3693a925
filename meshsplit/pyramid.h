// Resizes textures without mixing zones. S2 2.3-2.4, which leaves it open: a smaller texel takes its zone
// from the texels that it covers, and its RGB is the box-filtered RGB of the texels of that zone.
#pragma once

#include "meshsplit/zone_map.h"

namespace claque::meshsplit
{

// Resizes to any size. A new texel covers a box of old ones and takes the zone (a hole counts as one) with the largest
// area in the box. Ties go to the zone with the largest area in the box grown by a new texel's size on each side, then
// to the lower number. Its RGB is the mean of the box's texels of that zone, weighted by area.
ZoneMap resample(const ZoneMap &map, uint32_t width, uint32_t height);

// Returns the next smaller level: both sides halved, at least 1. Sides must be even or 1; otherwise use resample().
ZoneMap halve(const ZoneMap &map);

// Fills texels that are not covered (covered[texel] == 0) from the nearest covered texel, so that resizing brings
// nothing from outside into a chart. At equal distances the lower column wins, then the lower row. Does nothing if no
// texel is covered.
void dilate(ZoneMap &map, const std::vector<uint8_t> &covered);

// Unfolds mirrored wrapping: mirrored sides are doubled, so that repeating with halved coordinates looks the same.
ZoneMap unfold(const ZoneMap &map, bool mirror_s, bool mirror_t);

// Resizes to powers of two of at most max_px: other sides are resampled to the next power above (or to max_px), and
// sides that are too large are halved step by step.
ZoneMap fit(const ZoneMap &map, uint32_t max_px);
uint32_t fitted_side(uint32_t side, uint32_t max_px);
bool fits(const ZoneMap &map, uint32_t max_px);  // whether fit() would change nothing

}  // namespace claque::meshsplit
