// Decodes PNG and JPEG to RGBA with stb_image, compiled here with a memory limit, and WebP with libwebp, which a build
// may lack. Values that the decoder would trust (sizes, chunk lengths, the number of scans) are checked before it sees
// the bytes.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

#include "lib/model/model.h"

namespace claque::asset
{

struct ImageLimits {
    uint32_t max_px = 16384;       // width and height, at most 16384
    uint64_t max_bytes = 1 << 30;  // of the decoded RGBA
};

// Images with more pixels than this need at least one byte for 256 pixels: a file of a few kilobytes that claims 16384
// x 16384 pixels is an attack.
constexpr uint64_t pixels_for_nothing = 4096ull * 4096;

enum class ImageFormat { png, jpeg, webp, ktx, dds, unknown };
ImageFormat image_format(const uint8_t *bytes, size_t size);  // by the first bytes

// `name` is for messages. Throws base::Error: CLQ_FORMAT (damaged), CLQ_UNSUPPORTED (another format, named), CLQ_LIMIT;
// and std::bad_alloc.
model::Image decode_image(const uint8_t *bytes, size_t size, const std::string &name, const ImageLimits &limits);

}  // namespace claque::asset
