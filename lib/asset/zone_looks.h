// Where on the body the triangles of each zone lie, and the colours that texels and vertices have there.
#pragma once

#include <array>
#include <vector>

#include "lib/model/model.h"

namespace claque::asset
{

enum class Place : uint8_t { head, hands, elsewhere };
constexpr size_t place_count = 3;

struct ZoneLook {
    std::array<size_t, place_count> triangles{};  // whose first corner follows joints of that place
    // Sums of the colour in the middle of each triangle, without the zone's own colour.
    std::array<std::array<double, 3>, place_count> sums{};
    bool patterned = false;  // the texels or vertices are not all white

    size_t at(Place place) const { return triangles[static_cast<size_t>(place)]; }
    size_t all() const { return triangles[0] + triangles[1] + triangles[2]; }
    std::array<float, 3> mean(Place place) const;  // white without triangles
    std::array<float, 3> mean() const;
};

// One for each zone. Joints say the place by their names and those above them (head, hand, palm, wrist, fist). Things
// in a hand lie elsewhere. Only drawn parts count.
std::vector<ZoneLook> looks_of(const model::Model &model);

}  // namespace claque::asset
