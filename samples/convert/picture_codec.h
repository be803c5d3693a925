// The only file that uses stb: pictures of old formats to PNG.
#pragma once

#include <cstdint>
#include <string>

namespace convert
{

// PNG and JPEG stay as they are, others become PNG. Empty if the bytes are no picture.
std::string as_png_or_jpeg(const std::string &bytes);

// Whether some of its pixels are more transparent than not.
bool has_holes(const std::string &bytes);

std::string png_of(const std::string &rgba, uint32_t width, uint32_t height);

}  // namespace convert
