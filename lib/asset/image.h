// PNG and JPEG to RGBA. The decoder is stb_image in a compilation of our own, with a memory cap; what it would trust
// (sizes, chunk lengths, the number of scans) is checked before it sees the bytes.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

#include "lib/model/model.h"

namespace claque::asset
{

struct ImageLimits {
    uint32_t max_px = 16384;       // of either side, at most 16384
    uint64_t max_bytes = 1 << 30;  // of the decoded RGBA
};

// Beyond this many pixels an image must bring at least one byte per 256 of them: a few kilobytes that say they are
// 16384 x 16384 are an attack, not a picture.
constexpr uint64_t pixels_for_nothing = 4096ull * 4096;

enum class ImageFormat { png, jpeg, webp, ktx, dds, unknown };
ImageFormat image_format(const uint8_t *bytes, size_t size);  // by the first bytes

// `name` is for messages. Throws base::Error: CLQ_FORMAT (broken), CLQ_UNSUPPORTED (another format, named), CLQ_LIMIT;
// and std::bad_alloc.
model::Image decode_image(const uint8_t *bytes, size_t size, const std::string &name, const ImageLimits &limits);

}  // namespace claque::asset
