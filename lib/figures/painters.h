// The painters of the citizen. Each paints the charts that it names, in metres of the rest pose.
#pragma once

#include "lib/figures/canvas.h"

namespace claque::figures
{

Paint paint_head(const Texel &texel);   // face, ears, neck, hair
Paint paint_cloth(const Texel &texel);  // tunic, belt, borders
Paint paint_limb(const Texel &texel);   // arms and legs with the straps of the sandals
Paint paint_hand(const Texel &texel);
Paint paint_foot(const Texel &texel);

Paint paint_citizen(const Texel &texel);  // the painter of the texel's chart, with ambient occlusion

}  // namespace claque::figures
