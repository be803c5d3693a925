// Functions for painters: smooth steps, spots, lines and deterministic noise.
#pragma once

#include <algorithm>
#include <cmath>

#include <glm/vec2.hpp>

#include "lib/base/hash.h"

namespace claque::figures
{

inline float smoothstep(float from, float to, float x)
{
    const float t = std::clamp((x - from) / (to - from), 0.0f, 1.0f);
    return t * t * (3 - 2 * t);
}

// 1 at the centre, 0 from the radius on.
inline float spot(float distance, float radius)
{
    const float t = std::clamp(1 - std::fabs(distance) / radius, 0.0f, 1.0f);
    return t * t * (3 - 2 * t);
}
inline float spot(glm::vec2 p, glm::vec2 centre, glm::vec2 radii)
{
    const glm::vec2 d = (p - centre) / radii;
    return spot(std::sqrt(d.x * d.x + d.y * d.y), 1);
}

// The y of a polyline at x, constant beyond its ends. Points ascend in x.
template <size_t n>
float profile(const glm::vec2 (&points)[n], float x)
{
    if (x <= points[0].x) return points[0].y;
    for (size_t i = 1; i < n; ++i)
        if (x <= points[i].x)
            return points[i - 1].y +
                   (points[i].y - points[i - 1].y) * (x - points[i - 1].x) / (points[i].x - points[i - 1].x);
    return points[n - 1].y;
}

// Distance to a segment.
inline float to_segment(glm::vec2 p, glm::vec2 a, glm::vec2 b)
{
    const glm::vec2 ab = b - a, ap = p - a;
    const float t = std::clamp((ap.x * ab.x + ap.y * ab.y) / (ab.x * ab.x + ab.y * ab.y), 0.0f, 1.0f);
    const glm::vec2 d = ap - ab * t;
    return std::sqrt(d.x * d.x + d.y * d.y);
}

// Smooth noise in [0, 1) with features one unit wide.
inline float value_noise(float x, float y, uint64_t layer)
{
    const auto value = [layer](float i, float k) {
        return base::unit(base::mix(base::mix(layer + 0x51ed2701u) ^
                                    (static_cast<uint64_t>(static_cast<int64_t>(i)) * 0x9e3779b97f4a7c15ULL +
                                     static_cast<uint64_t>(static_cast<int64_t>(k)))));
    };
    const float i = std::floor(x), k = std::floor(y);
    const float u = smoothstep(0, 1, x - i), v = smoothstep(0, 1, y - k);
    return (value(i, k) * (1 - u) + value(i + 1, k) * u) * (1 - v) +
           (value(i, k + 1) * (1 - u) + value(i + 1, k + 1) * u) * v;
}

// The luminance of a fold of cloth from noise in [0, 1): a bright ridge beside a dark furrow.
inline float crease(float noise)
{
    const float x = noise * 2 - 1;
    return x * (1.25f - 0.5f * x * x) - 0.45f * spot(x + 0.30f, 0.22f);
}

}  // namespace claque::figures
