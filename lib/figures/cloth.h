// Garments are rows of columns round the body, sewn to each other, with sleeves from the armholes on. Column 0 is in
// front; columns are counted to the figure's left.
#pragma once

#include "lib/figures/parts.h"

namespace claque::figures
{

// The side of a column, and its place on the left half: the number of columns to the front.
template <int columns>
constexpr Side side_of(int column)
{
    return column <= columns / 2 ? Side::left : Side::right;
}
template <int columns>
constexpr size_t half_of(int column)
{
    return static_cast<size_t>(column <= columns / 2 ? column : columns - column);
}

// `count` columns of a row from `first`, left to right as seen from outside.
template <size_t columns>
Chain span(const std::array<uint32_t, columns> &row, int first, int count, float t)
{
    constexpr int all = static_cast<int>(columns);
    Chain chain;
    for (int k = first; k < first + count; ++k)
        chain.push_back({row[static_cast<size_t>((k + all) % all)], glm::vec2(static_cast<float>(k), t)});
    return chain;
}

// A copy of an edge with points of its own, so that normals are not shared across a sharp bend.
Chain doubled(Mesh &mesh, Chain chain);

// An armhole as a chain, closed by its first point: from behind over the shoulder to the front and below.
template <size_t points>
Chain around(const std::array<uint32_t, points> &armhole, const std::array<float, points + 1> &places)
{
    Chain chain;
    for (size_t i = 0; i <= points; ++i) chain.push_back({armhole[i % points], glm::vec2(places[i], 0)});
    return chain;
}

struct SleeveRow {
    float along;  // from the shoulder along the arm
    Girth girth;
};

// A sleeve from the armhole over its rows, each a ring of `count` points, and back inside to `inside_m` from the
// shoulder.
void add_sleeve(Mesh &mesh, Side side, Chain armhole, const std::vector<SleeveRow> &rows, int count, float inside_m);

}  // namespace claque::figures
