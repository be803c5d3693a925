// Finds colours that differ too little to be told apart, among many.
#pragma once

#include <cmath>
#include <string>
#include <unordered_map>

#include "lib/model/model.h"

namespace claque::meshsplit
{

using Rgb = std::array<float, 3>;

inline bool close(const Rgb &a, const Rgb &b)
{
    for (size_t k = 0; k < 3; ++k)
        if (std::fabs(a[k] - b[k]) > 1.0f / 512.0f) return false;
    return true;
}

// Numbers for colours, within families that are never mixed.
class NearColours
{
public:
    // Returns the lowest number of a colour of the family that is close to `rgb`; if there is none, `next` becomes the
    // number of `rgb` and is returned.
    uint32_t number(const std::string &family, const Rgb &rgb, uint32_t next)
    {
        uint32_t best = model::none;
        for (int d = 0; d < 27; ++d) {
            const auto found = cells_.find(key(family, rgb, {d % 3 - 1, d / 3 % 3 - 1, d / 9 - 1}));
            if (found != cells_.end() && found->second.number < best && close(found->second.rgb, rgb))
                best = found->second.number;
        }
        if (best != model::none) return best;
        cells_.emplace(key(family, rgb, {0, 0, 0}), Entry{rgb, next});
        return next;
    }

private:
    struct Entry {
        Rgb rgb;
        uint32_t number;
    };
    // Colours in one cell are close, so it has one entry; close colours are in cells that touch.
    static std::string key(const std::string &family, const Rgb &rgb, const std::array<int, 3> &step)
    {
        std::string out = family;
        for (size_t k = 0; k < 3; ++k)
            out += ' ' + std::to_string(static_cast<int>(std::floor(rgb[k] * 512.0f)) + step[k]);
        return out;
    }

    std::unordered_map<std::string, Entry> cells_;
};

}  // namespace claque::meshsplit
