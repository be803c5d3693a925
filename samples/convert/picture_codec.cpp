#include "samples/convert/picture_codec.h"

#include <cstdlib>
#include <memory>

#define STB_IMAGE_IMPLEMENTATION
#define STB_IMAGE_STATIC
#define STB_IMAGE_WRITE_IMPLEMENTATION
#define STB_IMAGE_WRITE_STATIC
#define STBI_NO_STDIO
#define STBI_WRITE_NO_STDIO
#define STBI_NO_HDR
#define STBI_MAX_DIMENSIONS 16384
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#pragma GCC diagnostic ignored "-Wmissing-field-initializers"
#include <stb/stb_image.h>
#include <stb/stb_image_write.h>
#pragma GCC diagnostic pop

namespace convert
{

std::string png_of(const std::string &rgba, uint32_t width, uint32_t height)
{
    std::string out;
    const auto append = [](void *to, void *bytes, int size) {
        static_cast<std::string *>(to)->append(static_cast<const char *>(bytes), static_cast<size_t>(size));
    };
    stbi_write_png_to_func(append, &out, static_cast<int>(width), static_cast<int>(height), 4, rgba.data(),
                           static_cast<int>(4 * width));
    return out;
}

namespace
{

struct Pixels {
    int width = 0, height = 0;
    std::string rgba;  // empty: the bytes are no picture
};

Pixels pixels_of(const std::string &bytes)
{
    Pixels out;
    int channels = 0;
    const std::unique_ptr<stbi_uc, void (*)(void *)> pixels(
        stbi_load_from_memory(reinterpret_cast<const stbi_uc *>(bytes.data()), static_cast<int>(bytes.size()),
                              &out.width, &out.height, &channels, 4),
        std::free);
    if (pixels)
        out.rgba.assign(reinterpret_cast<const char *>(pixels.get()),
                        size_t(4) * size_t(out.width) * size_t(out.height));
    return out;
}

}  // namespace

std::string as_png_or_jpeg(const std::string &bytes)
{
    if (bytes.compare(0, 4, "\x89PNG") == 0 || bytes.compare(0, 3, "\xff\xd8\xff") == 0) return bytes;
    const Pixels pixels = pixels_of(bytes);
    if (pixels.rgba.empty()) return {};
    return png_of(pixels.rgba, static_cast<uint32_t>(pixels.width), static_cast<uint32_t>(pixels.height));
}

bool has_holes(const std::string &bytes)
{
    const std::string rgba = pixels_of(bytes).rgba;
    for (size_t i = 3; i < rgba.size(); i += 4)
        if (static_cast<uint8_t>(rgba[i]) < 128) return true;
    return false;
}

}  // namespace convert
