#include "samples/labels/variation/jpeg.h"

#include <algorithm>
#include <cstdlib>
#include <memory>
#include <string>

#include "samples/scenes/check.h"

#if defined(CLAQUE_HAS_JPEG)
#define STB_IMAGE_IMPLEMENTATION
#define STB_IMAGE_STATIC
#define STB_IMAGE_WRITE_IMPLEMENTATION
#define STB_IMAGE_WRITE_STATIC
#define STBI_ONLY_JPEG
#define STBI_NO_STDIO
#define STBI_WRITE_NO_STDIO
#define STBI_NO_HDR
#define STBI_NO_LINEAR
#define STBI_NO_SIMD
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#pragma GCC diagnostic ignored "-Wmissing-field-initializers"
#include <stb/stb_image.h>
#include <stb/stb_image_write.h>
#pragma GCC diagnostic pop
#endif

namespace labels
{

#if defined(CLAQUE_HAS_JPEG)

bool can_compress() { return true; }

void compress(std::vector<uint8_t> &rgb, int width, int height, int quality)
{
    std::string file;
    const auto append = [](void *to, void *bytes, int size) {
        static_cast<std::string *>(to)->append(static_cast<const char *>(bytes), static_cast<size_t>(size));
    };
    int w = 0, h = 0, channels = 0;
    if (stbi_write_jpg_to_func(append, &file, width, height, 3, rgb.data(), quality) == 0)
        throw scenes::Failure("a picture could not be compressed as JPEG");
    const std::unique_ptr<stbi_uc, void (*)(void *)> read(
        stbi_load_from_memory(reinterpret_cast<const stbi_uc *>(file.data()), static_cast<int>(file.size()), &w, &h,
                              &channels, 3),
        std::free);
    if (!read || w != width || h != height) throw scenes::Failure("a picture in JPEG could not be read back");
    std::copy(read.get(), read.get() + rgb.size(), rgb.begin());
}

#else

bool can_compress() { return false; }

void compress(std::vector<uint8_t> &, int, int, int)
{
    throw scenes::Failure("this build cannot compress pictures: stb_image_write.h was not there");
}

#endif

}  // namespace labels
