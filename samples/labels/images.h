// PNG files of labels: 8 or 16 bits a channel, one channel or three.
#pragma once

#include <cstdint>
#include <vector>

namespace labels
{

// values: [channels * width * height], top row first. Throws scenes::Failure.
std::vector<unsigned char> png8(const std::vector<uint8_t> &values, int width, int height, int channels);
std::vector<unsigned char> png16(const std::vector<uint16_t> &values, int width, int height, int channels);

}  // namespace labels
