#include "samples/parity/write/zone_cover.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>

namespace parity
{
namespace
{

constexpr double margin = 0.01;  // texels

using Point = std::array<double, 2>;
using Corners = std::array<Point, 3>;

struct Range {
    double low, high;
    bool meets(const Range &other) const { return low <= other.high && other.low <= high; }
};

Range along(const Corners &corners, const Point &axis)
{
    Range out = {INFINITY, -INFINITY};
    for (const Point &p : corners) {
        const double at = p[0] * axis[0] + p[1] * axis[1];
        out = {std::min(out.low, at), std::max(out.high, at)};
    }
    return out;
}

// A triangle and the square of a texel meet unless an edge of the triangle separates them. Boxes were compared before.
bool touches(const Corners &corners, double x, double y)
{
    for (size_t k = 0; k < 3; ++k) {
        const Point &a = corners[k], &b = corners[(k + 1) % 3];
        const Point across = {b[1] - a[1], a[0] - b[0]};
        const double middle = (x + 0.5) * across[0] + (y + 0.5) * across[1];
        const double reach = (0.5 + margin) * (std::fabs(across[0]) + std::fabs(across[1]));
        if (!along(corners, across).meets({middle - reach, middle + reach})) return false;
    }
    return true;
}

size_t texel(int64_t i, uint32_t size, clq_wrap wrap)
{
    const int64_t n = int64_t{size};
    return static_cast<size_t>(wrap == CLQ_WRAP_CLAMP ? std::clamp<int64_t>(i, 0, n - 1) : (i % n + n) % n);
}

std::set<uint32_t> zones_of(const Corners &corners, const Texels &texels)
{
    std::set<uint32_t> out;
    const Range x = along(corners, {1, 0}), y = along(corners, {0, 1});
    const double columns = x.high - x.low + 2, rows = y.high - y.low + 2;
    constexpr double most_repeats = 16;
    if (!(columns < most_repeats * texels.width && rows < most_repeats * texels.height)) {
        out.insert(texels.zones.begin(), texels.zones.end());
        out.erase(CLQ_NONE);
        return out;
    }
    const auto first = [](double v) { return static_cast<int64_t>(std::floor(v - margin)); };
    const auto last = [](double v) { return static_cast<int64_t>(std::floor(v + margin)); };
    for (int64_t row = first(y.low); row <= last(y.high); ++row)
        for (int64_t column = first(x.low); column <= last(x.high); ++column)
            if (touches(corners, static_cast<double>(column), static_cast<double>(row)))
                out.insert(texels.zones[texel(row, texels.height, texels.wrap_t) * texels.width +
                                        texel(column, texels.width, texels.wrap_s)]);
    out.erase(CLQ_NONE);  // a hole shows nothing
    return out;
}

}  // namespace

std::vector<ZoneTriangles> zone_cover(const clq_triangles &triangles, const float *uvs, const Texels &texels)
{
    std::map<uint32_t, std::vector<uint32_t>> found;
    for (uint32_t i = 0; i < triangles.index_count; i += 3) {
        Corners corners{};
        for (size_t k = 0; k < 3; ++k) {
            const float *uv = uvs + 2 * static_cast<size_t>(triangles.indices[i + k]);
            corners[k] = {static_cast<double>(uv[0]) * texels.width, static_cast<double>(uv[1]) * texels.height};
        }
        for (const uint32_t zone : zones_of(corners, texels))
            found[zone].insert(found[zone].end(), triangles.indices + i, triangles.indices + i + 3);
    }
    std::vector<ZoneTriangles> out;
    for (auto &[zone, indices] : found) out.push_back({zone, std::move(indices)});
    return out;
}

}  // namespace parity
