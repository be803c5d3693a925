// A knee-length tunic: rows of fourteen columns from the hem over the belt and the overhanging cloth up to the armpits,
// a yoke over the shoulders with a wide neck, and sleeves joined to its armholes.

#include "lib/figures/cloth.h"
#include "lib/figures/skeleton.h"

namespace claque::figures
{

namespace
{

constexpr int columns = 14;  // 0 in front, 7 at the back, counted to the figure's left

// Unit directions of columns 0 to 7 on the left.
const std::array<glm::vec2, 8> directions = {{{0, 1},
                                              {0.44f, 0.90f},
                                              {0.79f, 0.62f},
                                              {0.975f, 0.24f},
                                              {0.975f, -0.24f},
                                              {0.79f, -0.62f},
                                              {0.44f, -0.90f},
                                              {0, -1}}};

// The offset of each column where the cloth falls in folds, as a fraction of the row's fold.
const std::array<float, columns> tunic_folds = {
    {-0.9f, 1.0f, -0.6f, 0.9f, -0.8f, 1.0f, -0.8f, 0.9f, -0.9f, 0.8f, -0.9f, 1.0f, -0.7f, 0.8f}};

struct Row {
    float y, side, front, back, ahead, fold, dip;
};

const std::array<Row, 7> rows = {{
    {0.510f, 0.215f, 0.174f, 0.184f, 0.000f, 0.032f, 0.006f},  // hem
    {0.690f, 0.203f, 0.156f, 0.174f, 0.000f, 0.022f, 0.000f},
    {0.870f, 0.184f, 0.136f, 0.158f, 0.000f, 0.009f, 0.000f},  // hips
    {1.012f, 0.156f, 0.113f, 0.116f, 0.000f, 0.002f, 0.000f},  // lower edge of the belt
    {1.060f, 0.154f, 0.113f, 0.112f, 0.000f, 0.000f, 0.000f},  // upper edge, behind the overhang
    {1.054f, 0.169f, 0.139f, 0.131f, 0.000f, 0.012f, 0.010f},  // overhang
    {1.195f, 0.163f, 0.134f, 0.127f, -0.003f, 0.008f, 0.000f},
}};

// The armpit row and the row above it, columns 0 to 7 on the left; then the shoulder seam from neck to arm.
const std::array<glm::vec3, 8> armpit = {{{0, 1.342f, 0.120f},
                                          {0.060f, 1.340f, 0.126f},
                                          {0.115f, 1.346f, 0.108f},
                                          {0.158f, 1.352f, 0.062f},
                                          {0.160f, 1.350f, -0.070f},
                                          {0.115f, 1.364f, -0.122f},
                                          {0.058f, 1.362f, -0.132f},
                                          {0, 1.362f, -0.128f}}};
const std::array<glm::vec3, 8> upper = {{neckline[0],
                                         neckline[1],
                                         {0.108f, 1.434f, 0.066f},
                                         {0.172f, 1.404f, 0.056f},
                                         {0.174f, 1.404f, -0.072f},
                                         {0.108f, 1.440f, -0.098f},
                                         neckline[3],
                                         neckline[4]}};
const std::array<glm::vec3, 3> shoulder_seam = {{neckline[2], {0.134f, 1.464f, -0.022f}, {0.184f, 1.456f, -0.016f}}};

// Girths: front, back, below, above.
const std::vector<SleeveRow> sleeve_rows = {{0.095f, {0.066f, 0.066f, 0.076f, 0.056f}},
                                            {0.235f, {0.078f, 0.074f, 0.094f, 0.054f}}};

using Ring = std::array<uint32_t, columns>;

Ring add_row(Mesh &mesh, const Row &row)
{
    Ring ring{};
    for (int k = 0; k < columns; ++k) {
        const Side side = k <= 7 ? Side::left : Side::right;
        const size_t half = static_cast<size_t>(k <= 7 ? k : columns - k);
        const glm::vec2 d = directions[half];
        const float fold = 1 + tunic_folds[static_cast<size_t>(k)] * row.fold / 0.18f;
        const float y = row.y + row.dip * tunic_folds[static_cast<size_t>((k + 3) % columns)];
        const glm::vec3 p(d.x * row.side * fold, y, row.ahead + d.y * (d.y > 0 ? row.front : row.back) * fold);
        ring[static_cast<size_t>(k)] = mesh.add(mirrored(p, side), row.y < 1.03f ? Region::skirt : Region::torso, side);
    }
    return ring;
}

Ring add_row(Mesh &mesh, const std::array<glm::vec3, 8> &half)
{
    Ring ring{};
    for (int k = 0; k < columns; ++k)
        ring[static_cast<size_t>(k)] =
            mesh.add(mirrored(half[static_cast<size_t>(k <= 7 ? k : columns - k)], k <= 7 ? Side::left : Side::right),
                     Region::torso);
    return ring;
}

// Chest, back and shoulders above the row of the armpits, at height `t` of the charts; then the sleeves.
void add_yoke(Mesh &mesh, const Ring &low, float t)
{
    const Ring high = add_row(mesh, upper);
    mesh.sew(Chart::tunic_front, Winding::as_given, span(low, -3, 7, t), span(high, -3, 7, t + 0.065f), Along::s);
    mesh.sew(Chart::tunic_back, Winding::as_given, span(low, 4, 7, t), span(high, 4, 7, t + 0.075f), Along::s);
    for (const Side side : {Side::left, Side::right}) {
        std::array<uint32_t, 3> seam{};
        for (size_t i = 0; i < 3; ++i) seam[i] = mesh.add(mirrored(shoulder_seam[i], side), Region::torso, side);
        const bool left = side == Side::left;
        const auto chain = [&](int first, float height, bool outwards) {
            Chain c;
            for (int i = 0; i < 3; ++i)
                c.push_back({seam[static_cast<size_t>(outwards ? i : 2 - i)],
                             glm::vec2(static_cast<float>(first + i), height)});
            return c;
        };
        const int front = left ? 1 : -3, back = left ? 4 : 8;
        mesh.sew(Chart::tunic_front, Winding::as_given, span(high, front, 3, t + 0.065f), chain(front, t + 0.15f, left),
                 Along::s);
        mesh.sew(Chart::tunic_back, Winding::as_given, span(high, back, 3, t + 0.075f), chain(back, t + 0.16f, !left),
                 Along::s);
        const auto at = [left](const Ring &ring, int k) {
            return ring[static_cast<size_t>(left ? k : (columns - k) % columns)];
        };
        const std::array<uint32_t, 5> armhole = {at(high, 4), seam[2], at(high, 3), at(low, 3), at(low, 4)};
        add_sleeve(mesh, side, around(armhole, {0, 0.26f, 0.5f, 0.66f, 0.86f, 1}), sleeve_rows, 7, 0.13f);
    }
}

}  // namespace

void add_tunic(Mesh &mesh)
{
    std::vector<Ring> rings;
    std::vector<float> heights;
    float t = 0;
    for (size_t r = 0; r < rows.size(); ++r) {
        rings.push_back(add_row(mesh, rows[r]));
        if (r > 0) t += rows[r].y > rows[r - 1].y ? rows[r].y - rows[r - 1].y : 0.02f;
        heights.push_back(t);
    }
    rings.push_back(add_row(mesh, armpit));
    heights.push_back(t += 0.095f);
    for (size_t r = 0; r + 1 < rings.size(); ++r) {
        mesh.sew(Chart::tunic_front, Winding::as_given, span(rings[r], -4, 9, heights[r]),
                 span(rings[r + 1], -4, 9, heights[r + 1]), Along::s);
        mesh.sew(Chart::tunic_back, Winding::as_given, span(rings[r], 4, 7, heights[r]),
                 span(rings[r + 1], 4, 7, heights[r + 1]), Along::s);
    }
    const uint32_t inside = mesh.add(glm::vec3(0, 0.78f, 0), Region::skirt);
    mesh.fan(Chart::tunic_inside, Winding::reversed, doubled(mesh, span(rings[0], 0, columns + 1, 0)),
             {inside, glm::vec2(-1, 1)});
    add_yoke(mesh, rings.back(), t);
}

}  // namespace claque::figures
