// Colours of individuals, drawn from the ranges of a model's zones as the crowd draws them.
#pragma once

#include <array>
#include <cmath>

#include "lib/crowd/colour_sample.h"
#include "lib/math/oklab.h"
#include "lib/model/model.h"

namespace claque::testing
{

constexpr uint64_t individuals = 64;

using Drawn = std::array<double, 3>;

inline Drawn drawn(const model::Model &model, uint32_t zone, uint64_t individual)
{
    double rgb[3];
    crowd::rgb_of(crowd::ColourSample(1, individual, zone).in(model.zones[zone].range), rgb);
    return {rgb[0], rgb[1], rgb[2]};
}

inline Drawn own_colour(const model::Model &model, uint32_t zone)
{
    const std::array<float, 3> &c = model.zones[zone].colour;
    return {double(c[0]), double(c[1]), double(c[2])};
}

// In OKLab, in which black and white are 1 apart.
inline double apart(const Drawn &a, const Drawn &b)
{
    double first[3], second[3], sum = 0;
    math::oklab_of(a.data(), first), math::oklab_of(b.data(), second);
    for (int k = 0; k < 3; ++k) sum += (first[k] - second[k]) * (first[k] - second[k]);
    return std::sqrt(sum);
}

// The zone's mean colour over all individuals.
inline Drawn mean_drawn(const model::Model &model, uint32_t zone)
{
    Drawn sum{};
    for (uint64_t i = 0; i < individuals; ++i)
        for (size_t k = 0; k < 3; ++k) sum[k] += drawn(model, zone, i)[k] / double(individuals);
    return sum;
}

// Blond, brown, black, red or grey.
inline bool is_hair_of_people(const Drawn &rgb)
{
    double hsb[3];
    math::rgb_to_hsb(rgb.data(), hsb);
    return hsb[1] < 0.2 || hsb[0] <= 42.5;
}

}  // namespace claque::testing
