// What the figure looks like close up. Each painter answers for the charts that it names, in the rest pose's metres.
#pragma once

#include "lib/figures/canvas.h"

namespace claque::figures
{

Paint paint_head(const Texel &texel);   // face, ears, neck, hair
Paint paint_cloth(const Texel &texel);  // tunic, belt, borders
Paint paint_limb(const Texel &texel);   // arms and legs with the straps of the sandals
Paint paint_hand(const Texel &texel);
Paint paint_foot(const Texel &texel);

Paint paint_citizen(const Texel &texel);  // whichever is asked for, with the shadows of openness

}  // namespace claque::figures
