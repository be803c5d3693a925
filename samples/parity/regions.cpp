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

// How far apart the colours of a region are, summed for each channel.
struct Apart {
    template <class Difference>
    void add(Difference of_channel)
    {
        ++pixels;
        for (size_t c = 0; c < 3; ++c) sums[c] += of_channel(c);
    }
    size_t pixels = 0;
    std::array<int64_t, 3> sums{};
};

// By the mean of the channel that is farthest apart.
WorstRegion worst_of(const std::map<uint64_t, Apart> &regions, size_t least)
{
    WorstRegion worst;
    for (const auto &[id, region] : regions) {
        int64_t most = 0;
        for (const int64_t sum : region.sums) most = std::max(most, std::abs(sum));
        consider(worst, id, region.pixels, static_cast<double>(most) / static_cast<double>(region.pixels), least);
    }
    return worst;
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
    std::map<uint64_t, Apart> sums;
    each_inner_pixel(ids, counted, [&](size_t i, uint64_t id) {
        sums[id].add([&](size_t c) { return std::abs(int{result.rgb[3 * i + c]} - int{reference.rgb[3 * i + c]}); });
    });
    return worst_of(sums, least_region_pixels);
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
    std::map<uint64_t, Apart> sums;
    for (size_t i = 0; i < ids.values.size(); ++i)
        if (counts(counted, i))
            sums[ids.values[i]].add([&](size_t c) { return result.rgb[3 * i + c] - reference.rgb[3 * i + c]; });
    return worst_of(sums, least_bias_pixels);
}

}  // namespace parity
