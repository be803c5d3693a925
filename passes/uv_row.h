// Rows of texels that a triangle crosses.
#pragma once

#include <algorithm>

#include "lib/model/template.h"

namespace claque::passes
{

constexpr double max_texels_across = 65536;  // of a triangle; beyond it no exact answer is tried

// Vertices are snapped, coordinates extrapolated and weights rounded by rasterisers, all within this part of a texel.
constexpr double snapping = 0.125;

inline int64_t wrapped(int64_t at, uint32_t size, model::Wrap wrap)
{
    const int64_t n = size;
    if (wrap == model::Wrap::clamp) return std::clamp<int64_t>(at, 0, n - 1);
    return (at % n + n) % n;
}

// Extends [low, high] by the x of the triangle's edges for y in [bottom, top].
inline void widen(const double (&x)[3], const double (&y)[3], double bottom, double top, double &low, double &high)
{
    for (int k = 0; k < 3; ++k) {
        const int next = (k + 1) % 3;
        const double y0 = std::max(std::min(y[k], y[next]), bottom), y1 = std::min(std::max(y[k], y[next]), top);
        if (y0 > y1) continue;
        const double dy = y[next] - y[k];
        for (const double at : {y0, y1}) {
            const double t = dy == 0 ? 0 : (at - y[k]) / dy;
            const double here = x[k] + t * (x[next] - x[k]);
            low = std::min(low, here), high = std::max(high, here);
        }
        if (dy == 0) low = std::min({low, x[k], x[next]}), high = std::max({high, x[k], x[next]});
    }
}

}  // namespace claque::passes
