#include "samples/parity/psnr.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <numeric>

namespace parity
{

double ColourDeviation::share_over(int lsb) const
{
    const size_t all = std::accumulate(histogram.begin(), histogram.end(), size_t{0});
    const size_t over = std::accumulate(histogram.begin() + lsb + 1, histogram.end(), size_t{0});
    return all == 0 ? 0 : static_cast<double>(over) / static_cast<double>(all);
}

ColourDeviation colour_deviation(const Picture &reference, const Picture &result, const std::vector<uint8_t> &counted)
{
    ColourDeviation d;
    uint64_t squares = 0;
    std::array<int64_t, 3> sums{};
    int64_t pixels = 0;
    for (size_t i = 0; i < reference.rgb.size(); i += 3) {
        int most = 0;
        for (size_t c = i; c < i + 3; ++c) {
            const int apart = std::abs(int{reference.rgb[c]} - int{result.rgb[c]});
            squares += static_cast<uint64_t>(apart) * static_cast<uint64_t>(apart);
            most = std::max(most, apart);
        }
        d.max = std::max(d.max, most);
        if (!counted.empty() && counted[i / 3] == 0) continue;
        ++d.histogram[static_cast<size_t>(most)];
        ++pixels;
        for (size_t c = 0; c < 3; ++c) sums[c] += int{result.rgb[i + c]} - int{reference.rgb[i + c]};
    }
    for (const int64_t sum : sums)
        if (pixels > 0) d.bias = std::max(d.bias, static_cast<double>(std::abs(sum)) / static_cast<double>(pixels));
    const double mean = static_cast<double>(squares) / static_cast<double>(reference.rgb.size());
    d.psnr_db = squares == 0 ? std::numeric_limits<double>::infinity() : 10 * std::log10(255.0 * 255.0 / mean);
    return d;
}

}  // namespace parity
