// The only file that uses libwebp.
#pragma once

#include <cstddef>
#include <cstdint>

#include "lib/asset/stb_decode.h"

namespace claque::asset::webp
{

// Width and height 0 if the header cannot be read, or if the build has no decoder.
stb::Size size_of(const uint8_t *bytes, size_t size);

// Fills out_rgba [4 * width * height], rows from the top. Returns null, or what is wrong.
const char *decode(const uint8_t *bytes, size_t size, const stb::Size &expected, uint8_t *out_rgba);

}  // namespace claque::asset::webp
