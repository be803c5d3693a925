// The painters of the decurion. Each paints its own charts, without ambient occlusion.
#pragma once

#include "lib/figures/painters.h"

namespace claque::figures
{

namespace decurion
{

Paint paint_aged_head(const Texel &texel);  // face, neck and ears; hair by paint_hair
Paint paint_aged_hair(const Texel &texel);
Paint paint_tunic(const Texel &texel);    // the visible tunic on breast and right arm
Paint paint_toga(const Texel &texel);     // the cloth round the body, the left sleeve
Paint paint_balteus(const Texel &texel);  // the roll over the shoulder, the lappet
Paint paint_shoe(const Texel &texel);
bool is_toga(const Texel &texel);

// The height above which hair grows.
float hair_edge(glm::vec3 p);

}  // namespace decurion

Paint paint_decurion(const Texel &texel);

}  // namespace claque::figures
