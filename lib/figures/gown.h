// Garments of twelve columns of cloth, sewn from a front and a back: toga, stola, exomis.
#pragma once

#include "lib/figures/cloth.h"

namespace claque::figures::gown
{

constexpr int columns = 12;  // 0 in front, 3 at the left side, 6 at the back
using Ring = std::array<uint32_t, columns>;
using Half = std::array<glm::vec3, 7>;  // columns 0 to 6; y = 0: no point, where the armhole is

// Of columns 0 to 6 from the body's axis, in the horizontal plane.
inline const std::array<glm::vec2, 7> directions = {
    {{0, 1}, {0.52f, 0.88f}, {0.88f, 0.50f}, {1, 0}, {0.88f, -0.50f}, {0.52f, -0.88f}, {0, -1}}};

// The same on both sides.
Ring add_row(Mesh &mesh, const Half &half);

struct Charts {
    Chart front, back;
};

// Columns all round. t: the heights of `low` and `high` in the charts.
void sew_rows(Mesh &mesh, Charts charts, const Ring &low, const Ring &high, glm::vec2 t);
// From the row of the armpits to the yoke, but for the armholes at columns 3 and 9.
void sew_yoke(Mesh &mesh, Charts charts, const Ring &low, const Ring &high, glm::vec2 t);

// From behind over the shoulder to the front and below, and where each point lies round the sleeve.
using Armhole = std::array<uint32_t, 6>;
constexpr std::array<float, 7> armhole_places = {0, 0.24f, 0.48f, 0.62f, 0.75f, 0.88f, 1};

// From the yoke, at height `t` of the charts, to the seam on the shoulder, whose points go from the neck to the arm.
// `low` is the row of the armpits.
Armhole sew_shoulder(Mesh &mesh, Charts charts, Side side, const Ring &low, const Ring &high,
                     const std::array<uint32_t, 3> &seam, float t);

}  // namespace claque::figures::gown
