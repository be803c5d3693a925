// What the patrician looks like close up; each painter answers for its own charts, before the shadows of openness.
#pragma once

#include "lib/figures/painters.h"

namespace claque::figures
{

namespace patrician
{

Paint paint_lady_head(const Texel &texel);  // face, neck, ears, and hair by the next
Paint paint_hair(const Texel &texel);
Paint paint_bun(const Texel &texel);
Paint paint_stola(const Texel &texel);   // gown, bodice, sleeves
Paint paint_palla(const Texel &texel);   // the band over the shoulder
Paint paint_mantle(const Texel &texel);  // where gown, bodice and left sleeve are covered by the palla
bool is_mantle(const Texel &texel);

// Light and dark of a fold from noise in [0, 1): a bright ridge beside a dark furrow.
float crease(float noise);

// Noise round the body, `count` features in all, without a seam behind.
float wrapped_noise(float around, int count, float y, uint64_t layer);

// Round the body like an angle, 0 in front, 4 at the back, negative on the right.
float around_body(glm::vec3 p);

// The height above which hair grows.
float hair_edge(glm::vec3 p);

}  // namespace patrician

Paint paint_patrician(const Texel &texel);

}  // namespace claque::figures
