// Pictures of stone, drawn by code.
#pragma once

#include "samples/scenes/geometry.h"
#include "samples/scenes/texture.h"

namespace scenes
{

constexpr float flagstone_metres = 8.0f;  // size of one repeat of the flagstones
constexpr float plaster_metres = 4.0f;

// Travertine slabs in courses of about a metre, with joints between; each slab has a tone of its own. Repeats.
Image flagstones(uint64_t seed);

constexpr Rgb plaster_mean = {0.930f, 0.925f, 0.911f};  // of its texels
// Weathered plaster or ashlar without joints: brightness, to be multiplied with a colour. Repeats.
Image plaster(uint64_t seed);

}  // namespace scenes
