// A picture of a host as a PNG file.
#pragma once

#include <fstream>
#include <string>

#include "samples/io/png.h"
#include "samples/scenes/check.h"

namespace hosts
{

// rgb: [3 * width * height], top row first. Throws scenes::Failure.
inline void write_picture(const std::string &path, const uint8_t *rgb, int width, int height)
{
    const std::vector<unsigned char> file = io::png(rgb, width, height, {});
    std::ofstream out(path, std::ios::binary);
    out.write(reinterpret_cast<const char *>(file.data()), static_cast<std::streamsize>(file.size()));
    if (!out.flush()) throw scenes::Failure(path + " could not be written");
}

}  // namespace hosts
