#define STB_IMAGE_WRITE_IMPLEMENTATION
#define STB_IMAGE_WRITE_STATIC
#define STBI_WRITE_NO_STDIO
#if defined(__GNUC__)
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#pragma GCC diagnostic ignored "-Wmissing-field-initializers"
#endif
#include <stb/stb_image_write.h>
#if defined(__GNUC__)
#pragma GCC diagnostic pop
#endif

#ifdef CLAQUE_HAS_WEBP
#include <webp/encode.h>
#endif

#include "tests/fuzz/seeds.h"
#include "tests/support/written_image.h"
#include "tests/unit/asset/png.h"

namespace fuzzing
{
namespace
{

constexpr int wide = 9, high = 7;

Bytes pixels(int channels)
{
    Bytes out;
    for (int i = 0; i < wide * high * channels; ++i) out.push_back(static_cast<uint8_t>(37 * i + i / wide * 5));
    return out;
}

Bytes jpeg(int channels, int quality)
{
    Bytes out;
    const auto keep = [](void *to, void *bytes, int size) {
        const uint8_t *first = static_cast<const uint8_t *>(bytes);
        static_cast<Bytes *>(to)->insert(static_cast<Bytes *>(to)->end(), first, first + size);
    };
    EXPECT_NE(stbi_write_jpg_to_func(keep, &out, wide, high, channels, pixels(channels).data(), quality), 0);
    return out;
}

#ifdef CLAQUE_HAS_WEBP
Bytes webp(bool lossless)
{
    uint8_t *made = nullptr;
    const size_t size = lossless ? WebPEncodeLosslessRGBA(pixels(4).data(), wide, high, 4 * wide, &made)
                                 : WebPEncodeRGBA(pixels(4).data(), wide, high, 4 * wide, 70, &made);
    const Bytes out(made, made + size);
    WebPFree(made);
    return out;
}
#endif

}  // namespace

void add_picture_seeds(std::vector<Seed> &out)
{
    using namespace claque::testing;
    out.push_back({"image", "png-colour", png_of(5, 4, [](uint32_t x, uint32_t y) {
                       return Colour{uint8_t(50 * x), uint8_t(60 * y), 7, uint8_t(255 - x)};
                   })});
    for (const uint8_t depth : {1, 2, 4, 8, 16}) {
        Bytes row(1 + (8u * depth + 7) / 8, 0x5a);
        row[0] = static_cast<uint8_t>(depth % 5);
        out.push_back({"image", "png-grey-" + std::to_string(depth), make_png(8, 3, depth, row, 3)});
    }
    out.push_back({"image", "jpeg-grey", jpeg(1, 60)});
    out.push_back({"image", "jpeg-colour", jpeg(3, 95)});
#ifdef CLAQUE_HAS_WEBP
    out.push_back({"image", "webp-lossless", webp(true)});
    out.push_back({"image", "webp-lossy", webp(false)});
#endif
}

}  // namespace fuzzing
