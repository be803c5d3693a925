#include "lib/asset/zone_clusters.h"

#include <algorithm>
#include <cmath>

#include "lib/asset/zone_coverage.h"
#include "lib/asset/zone_map.h"
#include "lib/base/error.h"
#include "lib/math/oklab.h"

namespace claque::asset
{

using base::fail;

namespace
{

constexpr uint32_t max_proposed = 48;
constexpr uint32_t bins = 32;              // per channel
constexpr double light_share = 0.5;        // weight of a difference in lightness relative to one in colour
constexpr double least_difference = 0.04;  // between two zones
constexpr uint64_t least_share = 200;      // a zone has at least one of this many texels
constexpr uint64_t least_spot = 4000;      // or of this many, if a quarter of them has its own kind all round
constexpr int max_rounds = 64, calming_rounds = 3;

using Point = std::array<double, 3>;

double distance2(const Point &a, const Point &b)
{
    double sum = 0;
    for (size_t k = 0; k < 3; ++k) sum += (a[k] - b[k]) * (a[k] - b[k]);
    return sum;
}

// The texels of one bin of the colour histogram.
struct Bin {
    Point at{};
    double texels = 0;
    size_t zone = 0;
};

size_t bin_of(const uint8_t *rgb) { return (size_t(rgb[0] / 8) * bins + rgb[1] / 8) * bins + rgb[2] / 8; }

std::vector<Bin> bins_of(const model::Image &image, const std::vector<uint8_t> &covered, std::vector<size_t> &place)
{
    std::vector<std::array<double, 4>> sums(bins * bins * bins);
    for (size_t i = 0; i < covered.size(); ++i) {
        if (!covered[i]) continue;
        std::array<double, 4> &sum = sums[bin_of(&image.rgba[4 * i])];
        for (size_t k = 0; k < 3; ++k) sum[k] += image.rgba[4 * i + k] / 255.0;
        ++sum[3];
    }
    std::vector<Bin> out;
    place.assign(sums.size(), 0);
    for (size_t i = 0; i < sums.size(); ++i) {
        if (sums[i][3] == 0) continue;
        const double rgb[3] = {sums[i][0] / sums[i][3], sums[i][1] / sums[i][3], sums[i][2] / sums[i][3]};
        double lab[3];
        math::oklab_of(rgb, lab);
        place[i] = out.size();
        out.push_back({{light_share * lab[0], lab[1], lab[2]}, sums[i][3], 0});
    }
    return out;
}

// Starts with the most frequent bin, then adds the bin farthest from all chosen ones, weighted by its frequency: a
// small area of a distinct colour counts, single texels do not.
std::vector<Point> first_middles(const std::vector<Bin> &all, uint32_t count)
{
    const auto most_frequent =
        std::max_element(all.begin(), all.end(), [](const Bin &a, const Bin &b) { return a.texels < b.texels; });
    std::vector<Point> middles = {most_frequent->at};
    std::vector<double> away(all.size(), 1e30);
    while (middles.size() < count) {
        size_t best = 0;
        double best_score = 0;
        for (size_t i = 0; i < all.size(); ++i) {
            away[i] = std::min(away[i], distance2(all[i].at, middles.back()));
            const double score = away[i] * std::sqrt(all[i].texels);
            if (away[i] > least_difference * least_difference && score > best_score) best = i, best_score = score;
        }
        if (best_score == 0) break;
        middles.push_back(all[best].at);
    }
    return middles;
}

size_t nearest(const std::vector<Point> &middles, const Point &at)
{
    size_t best = 0;
    for (size_t z = 1; z < middles.size(); ++z)
        if (distance2(middles[z], at) < distance2(middles[best], at)) best = z;
    return best;
}

void settle(std::vector<Bin> &all, std::vector<Point> &middles)
{
    for (int round = 0; round < max_rounds; ++round) {
        bool changed = round == 0;
        std::vector<std::array<double, 4>> sums(middles.size());
        for (Bin &bin : all) {
            const size_t zone = nearest(middles, bin.at);
            changed = changed || zone != bin.zone;
            bin.zone = zone;
            for (size_t k = 0; k < 3; ++k) sums[zone][k] += bin.texels * bin.at[k];
            sums[zone][3] += bin.texels;
        }
        if (!changed) return;
        for (size_t z = 0; z < middles.size(); ++z)
            for (size_t k = 0; k < 3 && sums[z][3] > 0; ++k) middles[z][k] = sums[z][k] / sums[z][3];
    }
}

// A texel takes the zone of its neighbours if more than half of the eight have one other zone.
void calm(ZoneProposal &out)
{
    const int w = static_cast<int>(out.width), h = static_cast<int>(out.height);
    std::vector<uint32_t> counts(max_proposed);
    for (int round = 0; round < calming_rounds; ++round) {
        const std::vector<uint16_t> before = out.zones;
        for (int y = 0; y < h; ++y)
            for (int x = 0; x < w; ++x) {
                const size_t at = size_t(y) * size_t(w) + size_t(x);
                if (before[at] == unknown_zone) continue;
                std::fill(counts.begin(), counts.end(), 0u);
                uint32_t known = 0;
                for (int dy = -1; dy <= 1; ++dy)
                    for (int dx = -1; dx <= 1; ++dx) {
                        const int nx = x + dx, ny = y + dy;
                        if ((dx == 0 && dy == 0) || nx < 0 || ny < 0 || nx >= w || ny >= h) continue;
                        const uint16_t zone = before[size_t(ny) * size_t(w) + size_t(nx)];
                        if (zone != unknown_zone) ++counts[zone], ++known;
                    }
                const auto most_frequent = std::max_element(counts.begin(), counts.end());
                if (2 * *most_frequent > known) out.zones[at] = static_cast<uint16_t>(most_frequent - counts.begin());
            }
    }
}

// How many texels of each zone have it all round: those of eyes and badges, not of soft edges between two zones.
std::vector<uint64_t> cores_of(const ZoneProposal &map)
{
    std::vector<uint64_t> cores(max_proposed);
    const size_t w = map.width;
    for (size_t y = 1; y + 1 < map.height; ++y)
        for (size_t x = 1; x + 1 < w; ++x) {
            const size_t at = y * w + x;
            const uint16_t zone = map.zones[at];
            bool is_core = zone != unknown_zone;
            for (const size_t row : {at - w, at, at + w})
                for (const size_t one : {row - 1, row, row + 1}) is_core = is_core && map.zones[one] == zone;
            if (is_core) ++cores[zone];
        }
    return cores;
}

// Orders zones by texels, most first. Zones of few texels that are soft edges between two others are merged into the
// nearest zone.
void order(const model::Image &image, ZoneProposal &out)
{
    struct Sum {
        std::array<uint64_t, 3> rgb{};
        uint64_t texels = 0;
        uint16_t zone = 0;
    };
    std::vector<Sum> sums(max_proposed);
    for (uint16_t z = 0; z < max_proposed; ++z) sums[z].zone = z;
    for (size_t i = 0; i < out.zones.size(); ++i) {
        if (out.zones[i] == unknown_zone) continue;
        Sum &sum = sums[out.zones[i]];
        for (size_t k = 0; k < 3; ++k) sum.rgb[k] += image.rgba[4 * i + k];
        ++sum.texels;
    }
    std::stable_sort(sums.begin(), sums.end(), [](const Sum &a, const Sum &b) { return a.texels > b.texels; });
    uint64_t all = 0;
    for (const Sum &sum : sums) all += sum.texels;
    const std::vector<uint64_t> cores = cores_of(out);
    std::vector<uint16_t> to(max_proposed, unknown_zone);
    for (const Sum &sum : sums) {
        const bool is_spot = 4 * cores[sum.zone] >= sum.texels && sum.texels * least_spot >= all;
        if ((sum.texels * least_share < all && !is_spot) || sum.texels == 0) continue;
        to[sum.zone] = static_cast<uint16_t>(out.means.size());
        std::array<uint8_t, 3> mean;
        for (size_t k = 0; k < 3; ++k) mean[k] = static_cast<uint8_t>((sum.rgb[k] + sum.texels / 2) / sum.texels);
        out.means.push_back(mean);
    }
    for (uint16_t &zone : out.zones)
        if (zone != unknown_zone) zone = to[zone];
}

}  // namespace

ZoneProposal propose_zones(const model::Model &model, uint32_t image, uint32_t count)
{
    if (image >= model.images.size())
        fail(CLQ_ARGUMENT, "image %u does not exist: '%s' has %zu", image, model.name.c_str(), model.images.size());
    if (count == 0 || count > max_proposed)
        fail(CLQ_ARGUMENT, "%u zones to propose: 1 to %u are wanted", count, max_proposed);
    const model::Image &texels = model.images[image];
    const std::vector<uint8_t> covered = covered_texels(model, image);
    if (std::find(covered.begin(), covered.end(), 1) == covered.end())
        fail(CLQ_ARGUMENT, "no triangle of '%s' shows image %u '%s'", model.name.c_str(), image, texels.name.c_str());
    std::vector<size_t> place;
    std::vector<Bin> all = bins_of(texels, covered, place);
    std::vector<Point> middles = first_middles(all, count);
    settle(all, middles);
    ZoneProposal out;
    out.width = texels.width, out.height = texels.height;
    out.zones.assign(covered.size(), unknown_zone);
    for (size_t i = 0; i < covered.size(); ++i)
        if (covered[i]) out.zones[i] = static_cast<uint16_t>(all[place[bin_of(&texels.rgba[4 * i])]].zone);
    calm(out);
    order(texels, out);
    return out;
}

}  // namespace claque::asset
