#include "lib/crowd/oklab_sampler.h"

#include <algorithm>
#include <cmath>

#include "lib/math/oklab.h"

namespace claque::crowd
{

namespace
{

constexpr uint32_t hue_cells = 24, other_cells = 12;
constexpr double darkest = 0.01;  // cube root of a brightness that 8 bits round to 0

double dot(const double a[3], const double b[3]) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

// The volume, area or length that is spanned by the derivatives along axes with a width.
double spanned_volume(const math::OklabSlopes &slopes, const bool live[3])
{
    const double *all[3] = {slopes.hue, slopes.saturation, slopes.brightness};
    const double *of[3];
    int count = 0;
    for (int axis = 0; axis < 3; ++axis)
        if (live[axis]) of[count++] = all[axis];
    if (count == 0) return 1;
    if (count == 1) return std::sqrt(dot(of[0], of[0]));
    const double *a = of[0], *b = of[1];
    const double cross[3] = {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
    return count == 2 ? std::sqrt(dot(cross, cross)) : std::fabs(dot(cross, of[2]));
}

// Area under a piecewise linear function through the nodes, in cells.
template <class Node>
double area(uint32_t nodes, const Node &node)
{
    if (nodes == 1) return node(0);
    double sum = (node(0) + node(nodes - 1)) / 2;
    for (uint32_t i = 1; i + 1 < nodes; ++i) sum += node(i);
    return sum;
}

// The position with a share u of the area to its left.
struct Quantile {
    uint32_t cell = 0;
    double within = 0;  // of the cell, [0, 1]
    double share(uint32_t nodes) const { return nodes == 1 ? 0 : (cell + within) / (nodes - 1); }
};

template <class Node>
Quantile quantile(uint32_t nodes, double u, const Node &node)
{
    Quantile at;
    if (nodes == 1) return at;
    double left = u * area(nodes, node), a = node(0), b = node(1);
    while (at.cell + 2 < nodes && left > (a + b) / 2) {
        left -= (a + b) / 2;
        ++at.cell;
        a = b;
        b = node(at.cell + 1);
    }
    const double under = a + std::sqrt(std::max(0.0, a * a + 2 * (b - a) * left));
    at.within = under > 0 ? std::clamp(2 * left / under, 0.0, 1.0) : u;
    return at;
}

}  // namespace

OklabSampler::OklabSampler(std::pmr::memory_resource *memory, const model::HsbRange &range)
    : density_(memory), marginals_{std::pmr::vector<float>(memory), std::pmr::vector<float>(memory)}
{
    const double turn = range.hue_min_deg > range.hue_max_deg ? 360 : 0;
    axes_[0] = {range.hue_min_deg, double(range.hue_max_deg) - double(range.hue_min_deg) + turn, hue_cells + 1};
    axes_[1] = {range.saturation_min, double(range.saturation_max) - double(range.saturation_min), other_cells + 1};
    // Brightness is sampled by its cube root, which keeps OKLab's derivatives finite down to black.
    const double dark = math::nth_root(double(range.brightness_min), 3),
                 light = math::nth_root(double(range.brightness_max), 3);
    min_brightness_ = double(range.brightness_min), max_brightness_ = double(range.brightness_max);
    axes_[2] = {dark, light - dark, other_cells + 1};
    bool live[3];
    for (int axis = 0; axis < 3; ++axis) {
        live[axis] = axes_[axis].width > 0;
        if (!live[axis]) axes_[axis].nodes = 1;
    }
    // Grey has any hue and black any saturation: an axis without effect has no extent.
    live[1] = live[1] && max_brightness_ > 0;
    live[0] = live[0] && max_brightness_ > 0 && range.saturation_max > 0;
    const uint32_t hues = axes_[0].nodes, saturations = axes_[1].nodes, brightnesses = axes_[2].nodes;
    const auto share = [](uint32_t i, uint32_t nodes) { return nodes == 1 ? 0 : double(i) / (nodes - 1); };
    density_.reserve(size_t(hues) * saturations * brightnesses);
    for (uint32_t h = 0; h < hues; ++h)
        for (uint32_t s = 0; s < saturations; ++s)
            for (uint32_t b = 0; b < brightnesses; ++b) {
                const double cube_root = std::max(darkest, axes_[2].value_at(share(b, brightnesses)));
                const math::OklabSlopes slopes =
                    math::oklab_slopes(axes_[0].value_at(share(h, hues)), axes_[1].value_at(share(s, saturations)),
                                       cube_root * cube_root * cube_root);
                density_.push_back(float(spanned_volume(slopes, live) * (live[2] ? 3 * cube_root * cube_root : 1)));
            }
    for (uint32_t h = 0; h < hues; ++h) {
        for (uint32_t s = 0; s < saturations; ++s) {
            const float *nodes = column(h, s);
            marginals_[0].push_back(float(area(brightnesses, [&](uint32_t i) { return double(nodes[i]); })));
        }
        const float *nodes = marginals_[0].data() + size_t(h) * saturations;
        marginals_[1].push_back(float(area(saturations, [&](uint32_t i) { return double(nodes[i]); })));
    }
}

Hsb OklabSampler::at(const double u[3]) const
{
    const uint32_t hues = axes_[0].nodes, saturations = axes_[1].nodes, brightnesses = axes_[2].nodes;
    const auto between = [](double a, double b, double t) { return a + (b - a) * t; };
    const Quantile h = quantile(hues, u[0], [&](uint32_t i) { return double(marginals_[1][i]); });
    const uint32_t h1 = std::min(h.cell + 1, hues - 1);
    const float *low = marginals_[0].data() + size_t(h.cell) * saturations,
                *high = marginals_[0].data() + size_t(h1) * saturations;
    const Quantile s = quantile(saturations, u[1], [&](uint32_t i) { return between(low[i], high[i], h.within); });
    const uint32_t s1 = std::min(s.cell + 1, saturations - 1);
    const float *corner[2][2] = {{column(h.cell, s.cell), column(h.cell, s1)}, {column(h1, s.cell), column(h1, s1)}};
    const Quantile b = quantile(brightnesses, u[2], [&](uint32_t i) {
        return between(between(corner[0][0][i], corner[0][1][i], s.within),
                       between(corner[1][0][i], corner[1][1][i], s.within), h.within);
    });
    const double hue = axes_[0].value_at(h.share(hues)), cube_root = axes_[2].value_at(b.share(brightnesses));
    return {hue >= 360 ? hue - 360 : hue, axes_[1].value_at(s.share(saturations)),
            std::clamp(cube_root * cube_root * cube_root, min_brightness_, max_brightness_)};
}

}  // namespace claque::crowd
