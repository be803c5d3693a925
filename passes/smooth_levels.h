// Images for levels that are shown so small that several texels fall on a pixel. GL_NEAREST shows one of these texels,
// and another one in the next frame, which flickers. In the images made here each texel gets the mean colour of the
// texels of its zone around it. Zone keys stay, so zones keep their borders to the pixel.
#pragma once

#include <vector>

#include "passes/prepared.h"

namespace claque::passes
{

constexpr uint32_t max_smooth_step = 4;

// Chooses for each surface of each level how far its image is smoothed: step n is for 2^n texels to a pixel, at the
// distance at which the level begins. Throws std::bad_alloc.
void prepare_smooth(PreparedTemplate &out);

// The texels of an image that triangles of the template show, for smooth_image().
std::vector<uint8_t> shown_texels(const model::Template &source, uint32_t texture, uint32_t width, uint32_t height);

// The RGBA bytes of an image in a step from 1 on, from those of the step before; step 0 is the image itself. Texels are
// means over about 2^step texels each way. Texels of other keys or that no triangle shows have no part in them.
std::vector<uint8_t> smooth_image(const model::Texture &texture, const std::vector<uint8_t> &rgba, uint32_t width,
                                  uint32_t height, const std::vector<uint8_t> &shown, uint32_t step);

}  // namespace claque::passes
