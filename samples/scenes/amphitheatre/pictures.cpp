#include "samples/scenes/amphitheatre/pictures.h"

#include <algorithm>
#include <cmath>

#include "samples/scenes/amphitheatre/plan.h"
#include "samples/scenes/geometry.h"
#include "samples/scenes/random.h"

namespace scenes::amphitheatre
{
namespace
{

constexpr double front_m = 2 * 6.8;  // width of the picture of the front

// Smooth noise in [0, 1] that repeats every wide by high cells over the unit square.
class Grain
{
public:
    Grain(uint64_t seed, int wide, int high) : seed_(seed), wide_(wide), high_(high) {}
    double operator()(double u, double v) const
    {
        const double x = u * wide_, y = v * high_;
        const int x0 = static_cast<int>(std::floor(x)), y0 = static_cast<int>(std::floor(y));
        const double fx = ease(x - x0), fy = ease(y - y0);
        const double low = at(x0, y0) * (1 - fx) + at(x0 + 1, y0) * fx;
        const double high = at(x0, y0 + 1) * (1 - fx) + at(x0 + 1, y0 + 1) * fx;
        return low * (1 - fy) + high * fy;
    }

private:
    static double ease(double t) { return t * t * (3 - 2 * t); }
    double at(int x, int y) const
    {
        const int column = ((x % wide_) + wide_) % wide_, row = ((y % high_) + high_) % high_;
        return random_unit(seed_, static_cast<uint64_t>(row) * 4096 + static_cast<uint64_t>(column), Purpose::grain);
    }
    uint64_t seed_;
    int wide_, high_;
};

uint8_t byte(double value) { return static_cast<uint8_t>(std::clamp(value, 0.0, 1.0) * 255 + 0.5); }

// Calls paint(u, v) for every texel; it returns a colour.
template <class Paint>
Image painted(int side, const Paint &paint)
{
    Image image;
    image.side_px = side;
    image.rgba.reserve(4 * static_cast<size_t>(side) * static_cast<size_t>(side));
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x) {
            const Rgb c = paint((x + 0.5) / side, (y + 0.5) / side);
            for (const float part : {c.r, c.g, c.b}) image.rgba.push_back(byte(static_cast<double>(part)));
            image.rgba.push_back(255);
        }
    return image;
}

Rgb grey(double tone, double warm = 0)
{
    return {static_cast<float>(tone * (1 + warm)), static_cast<float>(tone), static_cast<float>(tone * (1 - warm))};
}

// One storey of arches, x from the middle of a bay in metres, y from its foot; the storey is `high` metres.
double storey(double x, double y, double high, bool deep)
{
    const double arch = 2.1, spring = high * 0.52;
    const double from_centre = std::sqrt(x * x + std::max(0.0, y - spring) * std::max(0.0, y - spring));
    const bool opening = std::abs(x) < arch && (y < spring ? true : from_centre < arch);
    if (opening && y > (deep ? 0.9 : 0.0)) return 0.16 + 0.16 * std::clamp((std::abs(x) - 1.2) / 0.9, 0.0, 1.0);
    if (opening) return 0.72;                                  // a parapet
    if (from_centre < arch + 0.45 && y >= spring) return 1.0;  // the archivolt
    const double column = std::abs(std::abs(x) - 3.4);
    if (column < 0.55 && y < high - 1.7) return 1.02 - 0.42 * column / 0.55;
    if (y > high - 1.7) return y > high - 0.5 ? 1.06 : y > high - 0.75 ? 0.62 : 0.92;
    return 0.82;
}

}  // namespace

Image travertine(uint64_t seed)
{
    const Grain broad(seed + 11, 4, 3), bands(seed + 12, 6, 44), pits(seed + 13, 90, 160), fine(seed + 14, 256, 256);
    return painted(512, [&](double u, double v) {
        double tone = 0.93 + 0.09 * (broad(u, v) - 0.5) + 0.09 * (bands(u, v) - 0.5) + 0.07 * (fine(u, v) - 0.5);
        const double pit = pits(u, v);
        if (pit > 0.84) tone -= 0.5 * (pit - 0.84);
        return grey(tone, 0.012 * (broad(v, u) - 0.3));
    });
}

Image sand(uint64_t seed)
{
    const Grain broad(seed + 21, 5, 5), feet(seed + 22, 60, 60), rake(seed + 23, 9, 120), fine(seed + 24, 256, 256);
    return painted(512, [&](double u, double v) {
        double tone = 0.92 + 0.09 * (broad(u, v) - 0.5) + 0.05 * (rake(u, v) - 0.5) + 0.09 * (fine(u, v) - 0.5);
        const double foot = feet(u, v);
        if (foot > 0.8) tone -= 0.35 * (foot - 0.8);
        return grey(tone, 0.01);
    });
}

Image front(uint64_t seed)
{
    const Grain stains(seed + 31, 10, 3), fine(seed + 32, 200, 256), courses(seed + 33, 12, 64);
    return painted(512, [&](double u, double v) {
        const double y = v * height_m, bay = u * 2 - std::floor(u * 2);
        const double x = (bay - 0.5) * front_m / 2;
        double tone = 0;
        if (y < 12.3) tone = storey(x, y, 12.3, false);
        else if (y < 24.1) tone = storey(x, y - 12.3, 11.8, true);
        else if (y < 35.8) tone = storey(x, y - 24.1, 11.7, true);
        else {
            const double above = y - 35.8;
            const double pilaster = std::abs(std::abs(x) - 3.4);
            const bool window = u < 0.5 && std::abs(x) < 0.75 && above > 4.2 && above < 6.4;
            tone = window ? 0.2 : above > 11.6 ? 1.08 : above > 10.9 ? 0.66 : pilaster < 0.5 ? 0.98 : 0.86;
            if (above > 8.2 && above < 8.8 && std::abs(std::fmod(std::abs(x) + 1.15, 2.3) - 1.15) < 0.35) tone = 1.05;
        }
        tone *= 0.94 + 0.16 * (stains(u, v) - 0.5) + 0.06 * (fine(u, v) - 0.5) + 0.05 * (courses(u, v) - 0.5);
        return grey(tone * 0.95, 0.04);
    });
}

}  // namespace scenes::amphitheatre
