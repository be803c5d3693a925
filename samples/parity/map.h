// Pictures and maps of one value a pixel, top row first.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace parity
{

template <class Value>
struct Map {
    int width = 0, height = 0;
    std::vector<Value> values;  // [width * height], for pictures three bytes a pixel

    Map() = default;
    Map(int w, int h, Value value = {})
        : width(w), height(h), values(static_cast<size_t>(w) * static_cast<size_t>(h), value)
    {
    }
    size_t pixels() const { return static_cast<size_t>(width) * static_cast<size_t>(height); }
    size_t index(int x, int y) const
    {
        return static_cast<size_t>(y) * static_cast<size_t>(width) + static_cast<size_t>(x);
    }
    Value at(int x, int y) const { return values[index(x, y)]; }
};

struct Picture {
    int width = 0, height = 0;
    std::vector<uint8_t> rgb;  // [3 * width * height], sRGB

    Picture() = default;
    Picture(int w, int h) : width(w), height(h), rgb(3 * static_cast<size_t>(w) * static_cast<size_t>(h)) {}
    size_t pixels() const { return static_cast<size_t>(width) * static_cast<size_t>(height); }
};

}  // namespace parity
