// Pictures of two renderers, byte by byte, and the peak signal-to-noise ratio.
#pragma once

#include "samples/parity/map.h"

#include <array>

namespace parity
{

// Two pictures of the same size, at least one pixel.
struct ColourDeviation {
    int max = 0;                          // LSB of any channel
    std::array<size_t, 256> histogram{};  // of pixels by the largest difference of their three channels
    double psnr_db = 0;                   // over all channels, peak 255; infinite where nothing differs

    double share_over(int lsb) const;  // of the pixels
};
ColourDeviation colour_deviation(const Picture &reference, const Picture &result);

}  // namespace parity
