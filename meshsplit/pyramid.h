// Changes of a texture's size that never mix zones. S2 2.3-2.4 and what it wished for (SPEC row C3): the RGB of a
// smaller texel is the box-filtered RGB of the texels of its own zone, its zone is one that was there.
#pragma once

#include "meshsplit/zone_map.h"

namespace claque::meshsplit
{

// To any size, larger or smaller. A new texel covers a box of old ones and takes the zone (a hole counts as one) that
// covers most of the box; ties go to the zone that covers most of the box grown by a new texel's size on each side,
// then to the lower number. Its RGB is the mean of the old texels of that zone in the box, weighted by area.
ZoneMap resample(const ZoneMap &map, uint32_t width, uint32_t height);

// The next smaller level: both sides halved, down to 1. Sides are even or 1; resample() otherwise.
ZoneMap halve(const ZoneMap &map);

// Fills texels that nothing covers (covered[texel] == 0) from the covered texel nearest to them, so that a change of
// size brings nothing from outside into a chart. Equal distances: the lower column, then the lower row. Nothing happens
// where nothing is covered.
void dilate(ZoneMap &map, const std::vector<uint8_t> &covered);

// Unfolds mirrored wrapping: sides that mirror are doubled, so that repeat shows the same with halved coordinates.
ZoneMap unfold(const ZoneMap &map, bool mirror_s, bool mirror_t);

// Powers of two, none above max_px: sides that are none are resampled to the next above (or to max_px), sides that are
// too large are halved step by step.
ZoneMap fit(const ZoneMap &map, uint32_t max_px);
bool fits(const ZoneMap &map, uint32_t max_px);  // fit() would change nothing

}  // namespace claque::meshsplit
