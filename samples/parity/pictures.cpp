#include "samples/parity/pictures.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>

namespace parity
{
namespace
{

using Rgb = std::array<uint8_t, 3>;

Rgb heat(float value)
{
    constexpr std::array<std::array<float, 3>, 5> stops = {
        {{0, 0, 0}, {70, 20, 110}, {200, 60, 60}, {250, 160, 40}, {255, 250, 200}}};
    const float at = std::clamp(std::isnan(value) ? 1.0f : value, 0.0f, 1.0f) * (stops.size() - 1);
    const size_t i = std::min(static_cast<size_t>(at), stops.size() - 2);
    const float t = at - static_cast<float>(i);
    Rgb out = {};
    for (size_t c = 0; c < 3; ++c)
        out[c] = static_cast<uint8_t>(std::lround(stops[i][c] * (1 - t) + stops[i + 1][c] * t));
    return out;
}

void put(Picture &p, size_t i, const Rgb &rgb)
{
    std::copy(rgb.begin(), rgb.end(), p.rgb.begin() + static_cast<std::ptrdiff_t>(3 * i));
}

}  // namespace

Picture difference_picture(const Picture &reference, const Picture &result)
{
    Picture out(reference.width, reference.height);
    for (size_t i = 0; i < out.rgb.size(); ++i)
        out.rgb[i] =
            static_cast<uint8_t>(std::min(255, difference_gain * std::abs(int{reference.rgb[i]} - int{result.rgb[i]})));
    return out;
}

Picture heat_picture(const Map<float> &map)
{
    Picture out(map.width, map.height);
    for (size_t i = 0; i < map.values.size(); ++i) put(out, i, heat(map.values[i]));
    return out;
}

Map<float> depth_difference(const Map<float> &reference, const Map<float> &result)
{
    constexpr float least = 1e-7f, decades = 7;
    Map<float> out(reference.width, reference.height);
    for (size_t i = 0; i < out.values.size(); ++i) {
        const float apart = std::fabs(reference.values[i] - result.values[i]);
        out.values[i] = apart > least ? std::log10(apart / least) / decades : std::isnan(apart) ? 1.0f : 0.0f;
    }
    return out;
}

Picture marks_picture(const Map<Mark> &marks, const Picture *under)
{
    Picture out(marks.width, marks.height);
    for (size_t i = 0; i < marks.values.size(); ++i) {
        const int grey = under ? (under->rgb[3 * i] * 3 + under->rgb[3 * i + 1] * 6 + under->rgb[3 * i + 2]) / 25 : 0;
        const uint8_t g = static_cast<uint8_t>(grey);
        const Mark mark = marks.values[i];
        put(out, i, mark == Mark::border ? Rgb{255, 180, 0} : mark == Mark::outside ? Rgb{255, 40, 40} : Rgb{g, g, g});
    }
    return out;
}

}  // namespace parity
