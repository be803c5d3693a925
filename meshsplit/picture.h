// A picture of the split, for people: a texture's triangles over its zones, dirty ones marked (S1 Figs. 4 and 5).
#pragma once

#include "lib/model/template.h"

namespace claque::meshsplit
{

// RGBA, `scale` pixels a texel, row 0 is v = 0. Zones in distinct light colours, holes checked grey; clean triangles
// outlined thin and grey, dirty ones tinted and outlined red, on top. Of level 0.
std::vector<uint8_t> split_picture(const model::Template &tmpl, uint32_t texture, int scale);

}  // namespace claque::meshsplit
