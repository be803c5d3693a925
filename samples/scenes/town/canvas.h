// Tools for painting pictures: smooth noise that repeats, and functions of texels.
#pragma once

#include <algorithm>

#include "samples/scenes/geometry.h"
#include "samples/scenes/random.h"
#include "samples/scenes/texture.h"

namespace scenes::town
{

inline double smooth_step(double t)
{
    t = std::clamp(t, 0.0, 1.0);
    return t * t * (3 - 2 * t);
}

inline Rgb blend(Rgb a, Rgb b, double t)
{
    const float k = static_cast<float>(std::clamp(t, 0.0, 1.0));
    return {a.r + (b.r - a.r) * k, a.g + (b.g - a.g) * k, a.b + (b.b - a.b) * k};
}

// In [0, 1]; repeats every `cells_x` by `cells_y` lattice cells over the unit square.
class RepeatingNoise
{
public:
    RepeatingNoise(uint64_t seed, int cells_x, int cells_y)
        : wide_(cells_x), high_(cells_y), values_(static_cast<size_t>(cells_x) * static_cast<size_t>(cells_y))
    {
        for (size_t i = 0; i < values_.size(); ++i) values_[i] = random_unit(seed, i, Purpose::grain);
    }
    double operator()(double u, double v) const
    {
        const double x = u * wide_, y = v * high_;
        const int x0 = static_cast<int>(x), y0 = static_cast<int>(y);
        const double fx = smooth_step(x - x0), fy = smooth_step(y - y0);
        const double low = at(x0, y0) * (1 - fx) + at(x0 + 1, y0) * fx;
        const double high = at(x0, y0 + 1) * (1 - fx) + at(x0 + 1, y0 + 1) * fx;
        return low * (1 - fy) + high * fy;
    }

private:
    double at(int x, int y) const { return values_[static_cast<size_t>((y % high_) * wide_ + x % wide_)]; }
    int wide_, high_;
    std::vector<double> values_;
};

// Paints every texel by a function of u and v at its centre.
template <class Colour>
Image painted(int side_px, Colour colour)
{
    Image image;
    image.side_px = side_px;
    image.rgba.reserve(4 * static_cast<size_t>(side_px) * static_cast<size_t>(side_px));
    const auto byte = [](float value) {
        return static_cast<uint8_t>(std::clamp(static_cast<double>(value), 0.0, 1.0) * 255.0 + 0.5);
    };
    for (int y = 0; y < side_px; ++y)
        for (int x = 0; x < side_px; ++x) {
            const Rgb c = colour((x + 0.5) / side_px, (y + 0.5) / side_px);
            image.rgba.insert(image.rgba.end(), {byte(c.r), byte(c.g), byte(c.b), 255});
        }
    return image;
}

}  // namespace scenes::town
