// Draws a picture of the split: a texture's triangles over its zones, with dirty triangles marked (S1 Figs. 4 and 5).
#pragma once

#include "lib/model/template.h"

namespace claque::meshsplit
{

// Returns RGBA, `scale` pixels per texel; row 0 is v = 0. Zones have distinct light colours, holes a grey checker.
// Clean triangles have thin grey outlines; dirty ones are tinted and outlined red, on top. Of level 0.
std::vector<uint8_t> split_picture(const model::Template &tmpl, uint32_t texture, int scale);

}  // namespace claque::meshsplit
