// How a seated person behaves: the weights by which its clips are chosen.
#pragma once

#include <array>
#include <cstddef>

namespace scenes
{

constexpr size_t seated_count = 8;  // clips of a person who sits: the first ones of Act

struct Temperament {
    std::array<double, seated_count> odds;  // of the seated clips, while nothing happens
    double cheer, laugh;                    // what is added where all around applaud or laugh
    double rise;                            // the tendency to stand up

    static const Temperament grave, gracious, hearty;
};

// sit, lean, look, talk, applaud, cheer, laugh, wave
inline constexpr Temperament Temperament::grave = {{3.4, 1.8, 2.4, 2.2, 0.20, 0.02, 0.15, 0.02}, 1.0, 5.0, 0.5};
inline constexpr Temperament Temperament::gracious = {{2.8, 2.0, 2.4, 3.0, 0.20, 0.04, 0.30, 0.10}, 1.6, 9.0, 0.6};
inline constexpr Temperament Temperament::hearty = {{2.2, 2.6, 2.6, 2.4, 0.20, 0.12, 0.40, 0.16}, 6.0, 10.0, 1.6};

}  // namespace scenes
