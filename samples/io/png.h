// PNG files, with text chunks that say how they were made. The same picture and text give the same bytes: no times, no
// dates.
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace io
{

using Words = std::vector<std::pair<std::string, std::string>>;  // PNG text: keyword (1 to 79 Latin letters), text

// rgb: [3 * width * height], top row first. Throws std::runtime_error.
std::vector<unsigned char> png(const uint8_t *rgb, int width, int height, const Words &words);

// One channel or three of 8 or 16 bits, [channels * width * height], compressed less for speed. Throws
// std::runtime_error.
std::vector<unsigned char> quick_png(const std::vector<uint8_t> &values, int width, int height, int channels);
std::vector<unsigned char> quick_png(const std::vector<uint16_t> &values, int width, int height, int channels);

// The text that `path`, a PNG file, has for a keyword before its pixels; "": none.
std::string text_in_png(const std::string &path, const std::string &keyword);

// Returns true if `path` is a complete PNG file.
bool is_whole_png(const std::string &path);

}  // namespace io
