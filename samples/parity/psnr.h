// Pictures of two renderers, byte by byte, and the peak signal-to-noise ratio.
#pragma once

#include <array>

#include "samples/parity/map.h"

namespace parity
{

struct ColourDeviation {
    int max = 0;                          // LSB of any channel
    std::array<size_t, 256> histogram{};  // of pixels by the largest difference of their three channels
    // Between the mean colours of these pixels, in LSB of the channel that differs most.
    double bias = 0;
    double psnr_db = 0;  // over all channels of all pixels, peak 255; infinite if nothing differs

    double share_over(int lsb) const;  // of the pixels in the histogram
};

// Two pictures of the same size, at least one pixel.
//   counted   pixels of the histogram and the bias, nonzero; empty: all
ColourDeviation colour_deviation(const Picture &reference, const Picture &result,
                                 const std::vector<uint8_t> &counted = {});

}  // namespace parity
