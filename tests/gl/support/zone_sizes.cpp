#include "tests/gl/support/zone_sizes.h"

#include <algorithm>
#include <map>
#include <tuple>

namespace gltest
{

void fill_unseen(ZoneTexels &texels, const std::vector<uint8_t> &seen)
{
    const int64_t width = texels.width, height = texels.height;
    std::vector<int64_t> nearest_row(seen.size(), -1);  // in the texel's column
    for (int64_t x = 0; x < width; ++x) {
        std::vector<int64_t> rows;
        for (int64_t y = 0; y < height; ++y)
            if (seen[static_cast<size_t>(y * width + x)]) rows.push_back(y);
        for (int64_t y = 0, k = 0; y < height && !rows.empty(); ++y) {
            const auto next = [&] { return static_cast<size_t>(k + 1); };
            while (next() < rows.size() && std::abs(rows[next()] - y) < std::abs(rows[static_cast<size_t>(k)] - y)) ++k;
            nearest_row[static_cast<size_t>(y * width + x)] = rows[static_cast<size_t>(k)];
        }
    }
    const std::vector<uint16_t> before = texels.zones;
    for (int64_t y = 0; y < height; ++y)
        for (int64_t x = 0; x < width; ++x) {
            if (seen[static_cast<size_t>(y * width + x)]) continue;
            int64_t best = -1, best_x = 0, best_y = 0;
            for (int64_t apart = 0; apart < width && (best < 0 || apart * apart <= best); ++apart)
                for (const int64_t column : {x - apart, x + apart}) {
                    if (column < 0 || column >= width) continue;
                    const int64_t row = nearest_row[static_cast<size_t>(y * width + column)];
                    const int64_t square = apart * apart + (row - y) * (row - y);
                    if (row < 0 || (best >= 0 && std::tie(square, column, row) >= std::tie(best, best_x, best_y)))
                        continue;
                    best = square, best_x = column, best_y = row;
                }
            if (best >= 0)
                texels.zones[static_cast<size_t>(y * width + x)] = before[static_cast<size_t>(best_y * width + best_x)];
        }
}

namespace
{

// Areas of zones in a box, in units of which an old texel is `to_x` by `to_y`.
using Areas = std::map<uint16_t, uint64_t>;
Areas areas_in(const ZoneTexels &texels, uint64_t x0, uint64_t x1, uint64_t y0, uint64_t y1, uint64_t to_x,
               uint64_t to_y)
{
    Areas areas;
    for (uint64_t y = y0 / to_y; y * to_y < y1; ++y)
        for (uint64_t x = x0 / to_x; x * to_x < x1; ++x)
            areas[texels.zones[y * texels.width + x]] += (std::min(x1, (x + 1) * to_x) - std::max(x0, x * to_x)) *
                                                         (std::min(y1, (y + 1) * to_y) - std::max(y0, y * to_y));
    return areas;
}

}  // namespace

void resize(ZoneTexels &texels, uint32_t width, uint32_t height)
{
    ZoneTexels out = texels;
    out.width = width, out.height = height;
    out.zones.clear();
    const uint64_t w = texels.width, h = texels.height;
    for (uint64_t y = 0; y < height; ++y)
        for (uint64_t x = 0; x < width; ++x) {
            const Areas own = areas_in(texels, x * w, (x + 1) * w, y * h, (y + 1) * h, width, height);
            const Areas around = areas_in(texels, x == 0 ? 0 : (x - 1) * w, std::min((x + 2) * w, w * width),
                                          y == 0 ? 0 : (y - 1) * h, std::min((y + 2) * h, h * height), width, height);
            const auto less = [&](const auto &a, const auto &b) {
                return std::pair(a.second, around.at(a.first)) < std::pair(b.second, around.at(b.first));
            };
            out.zones.push_back(std::max_element(own.begin(), own.end(), less)->first);  // the first of equal ones
        }
    texels = std::move(out);
}

uint32_t fitted(uint32_t side, uint32_t most_px)
{
    uint32_t power = 1;
    while (power < side && 2 * power <= most_px) power *= 2;
    return power;
}

bool is_power_of_two(uint32_t side) { return fitted(side, side) == side; }

}  // namespace gltest
