// Fills a polygon with triangles by clipping ears (Meisters 1975); holes are first joined with the outside, where they
// touch it or by bridges.
#pragma once

#include "lib/asset/areas/area.h"

namespace claque::asset
{

// `rings`: the outside counter-clockwise, then holes clockwise, no point repeated. Appends triangles of points counted
// over all rings, plus `first`; all are counter-clockwise, and their areas sum up to the polygon's. Takes n log n steps
// for n points, and n^2 where most edges meet at one place, or are long, slanting and close together. False: rings
// cross, and what was appended does not fill the polygon.
bool triangulate(const std::vector<Ring> &rings, uint32_t first, std::vector<uint32_t> &out);

double signed_area(const Ring &ring);  // positive: counter-clockwise

}  // namespace claque::asset
