// The only file that uses stb_image: it holds its compilation switches, its memory limit and its C interface.
#pragma once

#include <cstddef>
#include <cstdint>

namespace claque::asset::stb
{

struct Size {
    uint32_t width = 0, height = 0;  // 0 if the header cannot be read
};

Size size_of(const uint8_t *bytes, size_t size);  // size < 2^31

// Fills out_rgba [4 * width * height], rows from the top. Allocates at most `cap_bytes`. Returns null, or what is
// wrong. Throws std::bad_alloc if the heap, and not the limit, refused.
const char *decode(const uint8_t *bytes, size_t size, uint64_t cap_bytes, const Size &expected, uint8_t *out_rgba);

}  // namespace claque::asset::stb
