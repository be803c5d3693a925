#include "samples/parity/depth.h"

#include <algorithm>
#include <cmath>

namespace parity
{
namespace
{

// The smallest value that at least this share of all values does not exceed.
double quantile(std::vector<double> &values, double share)
{
    const size_t needed = static_cast<size_t>(std::ceil(share * static_cast<double>(values.size())));
    const size_t at = std::max<size_t>(needed, 1) - 1;
    std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(at), values.end());
    return values[at];
}

}  // namespace

DepthDeviation depth_deviation(const Map<float> &reference, const Map<float> &result,
                               const std::vector<uint8_t> &counted)
{
    DepthDeviation d;
    std::vector<double> apart;
    double squares = 0;
    for (int y = 0; y < reference.height; ++y)
        for (int x = 0; x < reference.width; ++x) {
            const float a = reference.at(x, y), b = result.at(x, y);
            if ((a >= 1 && b >= 1) || (!counted.empty() && counted[reference.index(x, y)] == 0)) continue;
            ++d.compared;
            if (!std::isfinite(a) || !std::isfinite(b)) {
                ++d.not_finite;
                continue;
            }
            apart.push_back(std::fabs(double(a) - double(b)));
            squares += apart.back() * apart.back();
            if (apart.back() <= d.max) continue;
            d.max = apart.back();
            d.max_x = x;
            d.max_y = y;
        }
    if (apart.empty()) return d;
    d.rms = std::sqrt(squares / static_cast<double>(apart.size()));
    d.median = quantile(apart, 0.5);
    d.p99_9 = quantile(apart, 0.999);
    return d;
}

}  // namespace parity
