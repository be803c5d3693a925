// Fills a polygon with triangles by clipping ears (Meisters 1975); holes are first joined with the outside, where they
// touch it or by bridges (Eberly, "Triangulation by Ear Clipping").
#pragma once

#include "lib/asset/areas/area.h"

namespace claque::asset
{

// `rings`: the outside counter-clockwise, then holes clockwise, no point repeated. Appends triangles of points counted
// over all rings, plus `first`; all are counter-clockwise, and their areas sum up to the polygon's. Takes time in
// proportion to the square of the points. False: rings cross, and what was appended does not fill the polygon.
bool triangulate(const std::vector<Ring> &rings, uint32_t first, std::vector<uint32_t> &out);

double signed_area(const Ring &ring);  // positive: counter-clockwise

}  // namespace claque::asset
