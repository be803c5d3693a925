#include "meshsplit/cover.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace claque::meshsplit
{

using model::Wrap;

namespace
{

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double max_wraps = 16;
constexpr double max_texels = 1e9;  // beyond this, float coordinates do not resolve texels

struct Corners {
    double x[3], y[3];
};

Corners texels_of(const TexelGrid &grid, const UvTriangle &triangle)
{
    Corners c{};
    for (int k = 0; k < 3; ++k) {
        c.x[k] = double(triangle.corners[k].x) * grid.width;
        c.y[k] = double(triangle.corners[k].y) * grid.height;
    }
    return c;
}

struct Interval {
    double low = infinity, high = -infinity;
    void add(double v) { low = std::min(low, v), high = std::max(high, v); }
    bool empty() const { return !(low <= high); }
};

// Returns the x range of the closed triangle for y in [low, high].
Interval x_of_strip(const Corners &c, double low, double high)
{
    Interval x;
    for (int k = 0; k < 3; ++k) {
        if (c.y[k] >= low && c.y[k] <= high) x.add(c.x[k]);
        const int n = (k + 1) % 3;
        for (const double y : {low, high})
            if ((c.y[k] < y) != (c.y[n] < y) && c.y[k] != c.y[n])
                x.add(c.x[k] + (c.x[n] - c.x[k]) * ((y - c.y[k]) / (c.y[n] - c.y[k])));
    }
    return x;
}

int64_t texel(double coordinate, const Interval &allowed)
{
    return static_cast<int64_t>(std::floor(std::clamp(coordinate, allowed.low, allowed.high)));
}

uint32_t wrapped(int64_t i, uint32_t size)
{
    const int64_t r = i % int64_t(size);
    return static_cast<uint32_t>(r < 0 ? r + size : r);
}

void add_columns(const TexelGrid &grid, uint32_t row, double low, double high, std::vector<TexelSpan> &out)
{
    if (grid.wrap_s == Wrap::clamp) {
        const Interval inside{0, grid.width - 0.5};
        const int64_t first = texel(low, inside), last = texel(high, inside);
        out.push_back({row, static_cast<uint32_t>(first), static_cast<uint32_t>(last - first + 1)});
        return;
    }
    const int64_t first = static_cast<int64_t>(std::floor(low)), last = static_cast<int64_t>(std::floor(high));
    if (last - first + 1 >= int64_t(grid.width)) {
        out.push_back({row, 0, grid.width});
        return;
    }
    const uint32_t start = wrapped(first, grid.width), count = static_cast<uint32_t>(last - first + 1);
    const uint32_t before_edge = std::min(count, grid.width - start);
    out.push_back({row, start, before_edge});
    if (count > before_edge) out.push_back({row, 0, count - before_edge});
}

void add_all(const TexelGrid &grid, std::vector<TexelSpan> &out)
{
    for (uint32_t row = 0; row < grid.height; ++row) out.push_back({row, 0, grid.width});
}

double largest_corner(const Corners &c)
{
    double size = 0;
    for (int k = 0; k < 3; ++k) size = std::max({size, std::fabs(c.x[k]), std::fabs(c.y[k])});
    return size;
}

}  // namespace

double slack_of(const TexelGrid &grid, const UvTriangle &triangle)
{
    return sampling_slack + float_slack * largest_corner(texels_of(grid, triangle));
}

void cover(const TexelGrid &grid, const UvTriangle &triangle, std::vector<TexelSpan> &out)
{
    const Corners c = texels_of(grid, triangle);
    const double slack = slack_of(grid, triangle);
    const bool clamped = grid.wrap_t == Wrap::clamp;
    if (largest_corner(c) > max_texels) return add_all(grid, out);

    const double bottom = std::min({c.y[0], c.y[1], c.y[2]}) - slack;
    const double top = std::max({c.y[0], c.y[1], c.y[2]}) + slack;
    if (!clamped && top - bottom > max_wraps * grid.height) return add_all(grid, out);

    const Interval rows = clamped ? Interval{0, grid.height - 0.5} : Interval{-infinity, infinity};
    const int64_t first = texel(bottom, rows), last = texel(top, rows);
    for (int64_t row = first; row <= last; ++row) {
        // With clamping, the edge rows also cover everything beyond them.
        const bool lowest = clamped && row == 0, highest = clamped && row == int64_t(grid.height) - 1;
        const Interval x =
            x_of_strip(c, lowest ? -infinity : double(row) - slack, highest ? infinity : double(row) + 1 + slack);
        if (!x.empty()) add_columns(grid, wrapped(row, grid.height), x.low - slack, x.high + slack, out);
    }
}

}  // namespace claque::meshsplit
