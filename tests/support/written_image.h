// PNG files of any picture, for written characters.
#pragma once

#include <cstdint>
#include <functional>

#include "tests/support/gltf_maker.h"

namespace claque::testing
{

struct Colour {
    uint8_t r, g, b, a;
};

// 8 bits of red, green, blue and alpha, stored without compression, with true check sums.
Bytes png_of(uint32_t width, uint32_t height, const std::function<Colour(uint32_t x, uint32_t y)> &colour);

}  // namespace claque::testing
