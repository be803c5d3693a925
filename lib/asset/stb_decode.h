// The only door to stb_image. Everything about it that needs care is behind this: its compilation switches, its memory
// and its C interface.
#pragma once

#include <cstddef>
#include <cstdint>

namespace claque::asset::stb
{

struct Size {
    uint32_t width = 0, height = 0;  // 0 where the header is not understood
};

Size size_of(const uint8_t *bytes, size_t size);  // size < 2^31

// Fills out_rgba [4 * width * height], rows from the top. At most `cap_bytes` are allocated on the way. Returns null,
// or what is wrong. Throws std::bad_alloc where the heap, not the cap, refused.
const char *decode(const uint8_t *bytes, size_t size, uint64_t cap_bytes, const Size &expected, uint8_t *out_rgba);

}  // namespace claque::asset::stb
