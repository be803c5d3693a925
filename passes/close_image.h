// The image of a close texture: a template's texture with the colours of one individual's zones multiplied in.
#pragma once

#include "passes/prepared.h"

namespace claque::passes
{

// Bytes in GL of all its mip levels, at four a texel.
uint64_t close_bytes_of(uint32_t width, uint32_t height);

// Writes level 0, four bytes a texel. `source` is the template's image, `rgb` has three bytes for each of the texture's
// keys. Alpha is 0 in holes, else 255.
void paint_close_image(const model::Texture &texture, const uint8_t *source, const CloseImage &image,
                       const uint8_t *rgb, uint8_t *out);

// Halves an image in place; a side of one texel stays. The mean of texels, rounded to the nearest.
void halve(uint8_t *rgba, uint32_t &width, uint32_t &height);

}  // namespace claque::passes
