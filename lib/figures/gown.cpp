#include "lib/figures/gown.h"

namespace claque::figures::gown
{

Ring add_row(Mesh &mesh, const Half &half)
{
    Ring ring{};
    for (int k = 0; k < columns; ++k)
        if (half[half_of<columns>(k)].y > 0)
            ring[static_cast<size_t>(k)] =
                mesh.add(mirrored(half[half_of<columns>(k)], side_of<columns>(k)), Region::torso, side_of<columns>(k));
    return ring;
}

void sew_rows(Mesh &mesh, Charts charts, const Ring &low, const Ring &high, glm::vec2 t)
{
    mesh.sew(charts.front, Winding::as_given, span(low, -3, 7, t.x), span(high, -3, 7, t.y), Along::s);
    mesh.sew(charts.back, Winding::as_given, span(low, 3, 7, t.x), span(high, 3, 7, t.y), Along::s);
}

void sew_yoke(Mesh &mesh, Charts charts, const Ring &low, const Ring &high, glm::vec2 t)
{
    mesh.sew(charts.front, Winding::as_given, span(low, -2, 5, t.x), span(high, -2, 5, t.y), Along::s);
    mesh.sew(charts.back, Winding::as_given, span(low, 4, 5, t.x), span(high, 4, 5, t.y), Along::s);
}

Armhole sew_shoulder(Mesh &mesh, Charts charts, Side side, const Ring &low, const Ring &high,
                     const std::array<uint32_t, 3> &seam, float t)
{
    const bool left = side == Side::left;
    // To the right as seen from outside: from the neck to the arm, or from the arm to the neck.
    const auto chain = [&](int first, float height, bool outwards) {
        Chain c;
        for (size_t i = 0; i < 3; ++i)
            c.push_back(
                {seam[outwards ? i : 2 - i], glm::vec2(static_cast<float>(first) + static_cast<float>(i) / 2, height)});
        return c;
    };
    const auto at = [left](const Ring &ring, int k) {
        return ring[static_cast<size_t>(left ? k : (columns - k) % columns)];
    };
    const int front = left ? 1 : -2, back = left ? 4 : 7;
    mesh.sew(charts.front, Winding::as_given, span(high, front, 2, t), chain(front, t + 0.09f, left), Along::s);
    mesh.sew(charts.back, Winding::as_given, span(high, back, 2, t), chain(back, t + 0.08f, !left), Along::s);
    return {at(high, 4), seam[2], at(high, 2), at(low, 2), at(low, 3), at(low, 4)};
}

}  // namespace claque::figures::gown
