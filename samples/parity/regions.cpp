#include "samples/parity/regions.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>

#include "samples/parity/ids.h"

namespace parity
{
namespace
{

bool counts(const Counted &counted, size_t i) { return counted.empty() || counted[i] != 0; }

// Calls visit(index, id) for every pixel that counts and whose neighbours have the same id.
template <class Visit>
void each_inner_pixel(const Map<uint64_t> &ids, const Counted &counted, Visit visit)
{
    for (int y = 0; y < ids.height; ++y)
        for (int x = 0; x < ids.width; ++x)
            if (counts(counted, ids.index(x, y)) && !at_border(ids, x, y)) visit(ids.index(x, y), ids.at(x, y));
}

void consider(WorstRegion &worst, uint64_t id, size_t pixels, double value, size_t least = least_region_pixels)
{
    if (pixels < least) return;
    if (worst.regions++ == 0 || value > worst.value) {
        worst.id = id;
        worst.pixels = pixels;
        worst.value = value;
    }
}

double median(std::vector<double> &values)
{
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

}  // namespace

WorstRegion worst_colour(const Map<uint64_t> &ids, const Picture &reference, const Picture &result,
                         const Counted &counted)
{
    struct Sum {
        size_t pixels = 0;
        std::array<uint64_t, 3> apart{};
    };
    std::map<uint64_t, Sum> sums;
    each_inner_pixel(ids, counted, [&](size_t i, uint64_t id) {
        Sum &s = sums[id];
        ++s.pixels;
        for (size_t c = 0; c < 3; ++c)
            s.apart[c] += static_cast<uint64_t>(std::abs(int{reference.rgb[3 * i + c]} - int{result.rgb[3 * i + c]}));
    });
    WorstRegion worst;
    for (const auto &[id, s] : sums)
        consider(
            worst, id, s.pixels,
            static_cast<double>(*std::max_element(s.apart.begin(), s.apart.end())) / static_cast<double>(s.pixels));
    return worst;
}

WorstRegion worst_depth(const Map<uint64_t> &ids, const Map<float> &reference, const Map<float> &result,
                        const Counted &counted)
{
    std::map<uint64_t, std::vector<double>> differences;
    each_inner_pixel(ids, counted, [&](size_t i, uint64_t id) {
        const double apart = std::fabs(double(reference.values[i]) - double(result.values[i]));
        differences[id].push_back(std::isnan(apart) ? std::numeric_limits<double>::infinity() : apart);
    });
    WorstRegion worst;
    for (auto &[id, values] : differences) consider(worst, id, values.size(), median(values));
    return worst;
}

WorstRegion worst_ids(const Map<uint64_t> &reference, const Map<uint64_t> &result, const Counted &counted)
{
    struct Sum {
        size_t pixels = 0, different = 0;
    };
    std::map<uint64_t, Sum> sums;
    each_inner_pixel(reference, counted, [&](size_t i, uint64_t id) {
        ++sums[id].pixels;
        sums[id].different += result.values[i] != id;
    });
    WorstRegion worst;
    for (const auto &[id, s] : sums)
        consider(worst, id, s.pixels, static_cast<double>(s.different) / static_cast<double>(s.pixels));
    return worst;
}

WorstRegion worst_bias(const Map<uint64_t> &ids, const Picture &reference, const Picture &result,
                       const Counted &counted)
{
    struct Sum {
        size_t pixels = 0;
        std::array<int64_t, 3> apart{};
    };
    std::map<uint64_t, Sum> sums;
    for (size_t i = 0; i < ids.values.size(); ++i) {
        if (!counts(counted, i)) continue;
        Sum &s = sums[ids.values[i]];
        ++s.pixels;
        for (size_t c = 0; c < 3; ++c) s.apart[c] += int{result.rgb[3 * i + c]} - int{reference.rgb[3 * i + c]};
    }
    WorstRegion worst;
    for (const auto &[id, s] : sums) {
        int64_t most = 0;
        for (const int64_t apart : s.apart) most = std::max(most, std::abs(apart));
        consider(worst, id, s.pixels, static_cast<double>(most) / static_cast<double>(s.pixels), least_bias_pixels);
    }
    return worst;
}

}  // namespace parity
