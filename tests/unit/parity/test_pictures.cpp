#include "tests/unit/parity/test_pictures.h"

#include <algorithm>

namespace parity
{
namespace
{

template <class Value>
Picture picture(int width, int height, Value value)
{
    Picture p(width, height);
    size_t i = 0;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            for (int c = 0; c < 3; ++c) p.rgb[i++] = static_cast<uint8_t>(value(x, y, c));
    return p;
}

int pattern_at(int x, int y, int c, int variant)
{
    return (x * (7 + c) + y * 13 + x * y / 3 * (5 + variant) + c * 40) & 255;
}

}  // namespace

Picture pattern(int width, int height, int variant)
{
    return picture(width, height, [variant](int x, int y, int c) { return pattern_at(x, y, c, variant); });
}

Picture noisy_pattern(int width, int height)
{
    return picture(width, height, [](int x, int y, int c) {
        return std::clamp(pattern_at(x, y, c, 0) + (x * 31 + y * 17) % 23 - 11, 0, 255);
    });
}

Picture inverted(Picture p)
{
    for (uint8_t &v : p.rgb) v = static_cast<uint8_t>(255 - v);
    return p;
}

Picture filled(int width, int height, uint8_t value)
{
    Picture p(width, height);
    std::fill(p.rgb.begin(), p.rgb.end(), value);
    return p;
}

}  // namespace parity
