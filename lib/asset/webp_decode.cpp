#include "lib/asset/webp_decode.h"

#ifdef CLAQUE_HAS_WEBP

#include <new>

#include <webp/decode.h>

namespace claque::asset::webp
{

stb::Size size_of(const uint8_t *bytes, size_t size)
{
    WebPBitstreamFeatures found;
    if (WebPGetFeatures(bytes, size, &found) != VP8_STATUS_OK || found.width <= 0 || found.height <= 0) return {};
    return {static_cast<uint32_t>(found.width), static_cast<uint32_t>(found.height)};
}

const char *decode(const uint8_t *bytes, size_t size, const stb::Size &expected, uint8_t *out_rgba)
{
    WebPDecoderConfig config;
    if (!WebPInitDecoderConfig(&config)) return "libwebp has another interface than its header";
    if (WebPGetFeatures(bytes, size, &config.input) != VP8_STATUS_OK) return "its header is broken";
    if (config.input.has_animation) return "it is a film";
    config.output.colorspace = MODE_RGBA;
    config.output.is_external_memory = 1;
    config.output.u.RGBA.rgba = out_rgba;
    config.output.u.RGBA.stride = static_cast<int>(4 * expected.width);
    config.output.u.RGBA.size = size_t(4) * expected.width * expected.height;
    switch (WebPDecode(bytes, size, &config)) {
        case VP8_STATUS_OK:
            return nullptr;
        case VP8_STATUS_OUT_OF_MEMORY:
            throw std::bad_alloc();
        case VP8_STATUS_NOT_ENOUGH_DATA:
            return "it is cut off";
        default:
            return "it is broken";
    }
}

}  // namespace claque::asset::webp

#else

namespace claque::asset::webp
{

stb::Size size_of(const uint8_t *, size_t) { return {}; }
const char *decode(const uint8_t *, size_t, const stb::Size &, uint8_t *) { return "the build has no decoder"; }

}  // namespace claque::asset::webp

#endif
