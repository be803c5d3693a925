#include "tests/golden/picture.h"

#include <algorithm>
#include <cstdlib>
#include <fstream>

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#define STB_IMAGE_IMPLEMENTATION
#define STB_IMAGE_STATIC
#define STBI_ONLY_PNG
#include <stb/stb_image.h>
#pragma GCC diagnostic pop

Picture read_picture(const std::string &path)
{
    Picture out;
    int channels = 0;
    unsigned char *data = stbi_load(path.c_str(), &out.width, &out.height, &channels, 3);
    if (!data) return Picture();
    out.rgb.assign(data, data + 3 * static_cast<size_t>(out.width) * static_cast<size_t>(out.height));
    stbi_image_free(data);
    return out;
}

Difference compare(const Picture &a, const Picture &b, int allowed_steps)
{
    Difference out;
    if (a.width != b.width || a.height != b.height || a.rgb.empty()) {
        out.pixels = std::max<uint64_t>(1, std::max(a.rgb.size(), b.rgb.size()) / 3);
        out.most = 255;
        return out;
    }
    for (size_t i = 0; i < a.rgb.size(); i += 3) {
        int most = 0;
        for (size_t k = 0; k < 3; ++k) most = std::max(most, std::abs(a.rgb[i + k] - b.rgb[i + k]));
        out.pixels += most > allowed_steps;
        out.most = std::max(out.most, most);
    }
    return out;
}

void write_difference(const std::string &path, const Picture &a, const Picture &b)
{
    if (a.width != b.width || a.height != b.height) return;
    std::ofstream file(path, std::ios::binary);
    file << "P5 " << a.width << ' ' << a.height << " 255\n";
    for (size_t i = 0; i < a.rgb.size(); i += 3)
        file.put(std::equal(a.rgb.begin() + static_cast<long>(i), a.rgb.begin() + static_cast<long>(i) + 3,
                            b.rgb.begin() + static_cast<long>(i))
                     ? '\0'
                     : '\xff');
}
