#include "tests/cli/picture.h"

#include <png.h>

namespace cli_test
{

int Picture::count_of(const std::array<int, 3> &colour) const
{
    int count = 0;
    for (size_t i = 0; i + 2 < rgb.size(); i += 3)
        count += rgb[i] == colour[0] && rgb[i + 1] == colour[1] && rgb[i + 2] == colour[2];
    return count;
}

Picture picture_of(const std::string &path)
{
    Picture picture;
    png_image image = {};
    image.version = PNG_IMAGE_VERSION;
    if (!png_image_begin_read_from_file(&image, path.c_str())) return picture;
    image.format = PNG_FORMAT_RGB;
    picture.rgb.resize(PNG_IMAGE_SIZE(image));
    if (!png_image_finish_read(&image, nullptr, picture.rgb.data(), 0, nullptr)) return {};
    picture.width = static_cast<int>(image.width);
    picture.height = static_cast<int>(image.height);
    return picture;
}

}  // namespace cli_test
