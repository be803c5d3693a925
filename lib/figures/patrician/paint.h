// The painters of the patrician. Each paints its own charts, without ambient occlusion.
#pragma once

#include "lib/figures/painters.h"

namespace claque::figures
{

namespace patrician
{

Paint paint_lady_head(const Texel &texel);  // face, neck and ears; hair by paint_hair
Paint paint_hair(const Texel &texel);
Paint paint_bun(const Texel &texel);
Paint paint_stola(const Texel &texel);   // gown, bodice, sleeves
Paint paint_palla(const Texel &texel);   // the band over the shoulder
Paint paint_mantle(const Texel &texel);  // gown, bodice and left sleeve where the palla covers them
bool is_mantle(const Texel &texel);

// The luminance of a fold from noise in [0, 1): a bright ridge beside a dark furrow.
float crease(float noise);

// Noise round the body with `count` features in all and no seam at the back.
float wrapped_noise(float around, int count, float y, uint64_t layer);

// An angle-like coordinate round the body, 0 in front, 4 at the back, negative on the right.
float around_body(glm::vec3 p);

// The height above which hair grows.
float hair_edge(glm::vec3 p);

}  // namespace patrician

Paint paint_patrician(const Texel &texel);

}  // namespace claque::figures
