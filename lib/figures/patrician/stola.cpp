// The stola: twelve columns of cloth from the ankles over hips and the girdle under the breast to the armpits, with a
// yoke and short sleeves. Between the palla's lower edge and the waist the same surface is the palla, which covers the
// stola there.
#include "lib/figures/gown.h"
#include "lib/figures/patrician/patrician.h"
#include "lib/figures/skeleton.h"

namespace claque::figures::patrician
{

namespace
{

using gown::Ring, gown::add_row, gown::columns, gown::directions;
constexpr gown::Charts bodice_charts = {bodice_front, bodice_back};

const std::array<float, columns> folds = {
    {-0.9f, 1.0f, -0.5f, 0.8f, -0.8f, 1.0f, -0.8f, 0.9f, -0.7f, 0.9f, -0.8f, 0.9f}};

struct Row {
    float y, side, front, back, ahead, fold;
    float slant;   // how much higher the left is than the right, as a slope
    float valley;  // depth of the middle of the front between the legs
};

// Rows are close together near the knees, where a sitter's cloth bends.
const std::array<Row, 8> rows = {{
    {0.040f, 0.222f, 0.172f, 0.164f, 0.000f, 0.032f, 0, 0.006f},  // hem
    {0.240f, 0.200f, 0.156f, 0.144f, 0.000f, 0.022f, 0, 0.022f},
    {0.370f, 0.188f, 0.148f, 0.126f, 0.000f, 0.012f, 0, 0.036f},
    {0.520f, 0.182f, 0.142f, 0.132f, 0.000f, 0.008f, 0.20f, 0.040f},
    {0.610f, 0.198f, 0.160f, 0.170f, 0.000f, 0.010f, 0.32f, 0.034f},  // the palla's lower edge
    {0.900f, 0.196f, 0.136f, 0.166f, -0.004f, 0.006f, 0.010f, 0.008f},
    {1.070f, 0.158f, 0.124f, 0.118f, -0.004f, 0.006f, 0.030f, 0},  // its upper edge
    {1.196f, 0.136f, 0.104f, 0.098f, -0.006f, 0.003f, 0, 0},       // girdle
}};

const gown::Half bust = {{{0, 1.276f, 0.118f},
                          {0.074f, 1.274f, 0.158f},
                          {0.130f, 1.276f, 0.088f},
                          {0.150f, 1.276f, -0.004f},
                          {0.126f, 1.280f, -0.088f},
                          {0.070f, 1.284f, -0.118f},
                          {0, 1.284f, -0.112f}}};
const gown::Half armpit = {{{0, 1.340f, 0.116f},
                            {0.070f, 1.340f, 0.134f},
                            {0.134f, 1.346f, 0.068f},
                            {0.148f, 1.336f, -0.006f},
                            {0.134f, 1.352f, -0.086f},
                            {0.068f, 1.362f, -0.122f},
                            {0, 1.362f, -0.120f}}};
const gown::Half upper = {{bodice_neckline[0],
                           bodice_neckline[1],
                           {0.153f, 1.408f, 0.050f},
                           {0, 0, 0},  // the armhole
                           {0.155f, 1.410f, -0.070f},
                           bodice_neckline[3],
                           bodice_neckline[4]}};
const std::array<glm::vec3, 3> shoulder_seam = {
    {bodice_neckline[2], {0.138f, 1.458f, -0.022f}, {0.172f, 1.446f, -0.016f}}};

// Girths: front, back, below, above.
const std::vector<SleeveRow> sleeve_rows = {{0.100f, {0.052f, 0.054f, 0.062f, 0.043f}},
                                            {0.255f, {0.058f, 0.058f, 0.072f, 0.042f}}};

Ring add_row(Mesh &mesh, const Row &row)
{
    Ring ring{};
    for (int k = 0; k < columns; ++k) {
        const Side side = side_of<columns>(k);
        const glm::vec2 d = directions[half_of<columns>(k)];
        const float fold = 1 + folds[static_cast<size_t>(k)] * row.fold / 0.18f;
        const float across = mirrored(glm::vec3(d.x * row.side, 0, 0), side).x;
        const glm::vec3 p(d.x * row.side * fold, row.y + row.slant * across,
                          row.ahead + d.y * (d.y > 0 ? row.front : row.back) * fold - (k == 0 ? row.valley : 0));
        ring[static_cast<size_t>(k)] = mesh.add(mirrored(p, side), row.y < 1.03f ? heavy_cloth : Region::torso, side);
    }
    return ring;
}

void add_shoulder(Mesh &mesh, Side side, const Ring &low, const Ring &high, float t)
{
    std::array<uint32_t, 3> seam{};
    for (size_t i = 0; i < 3; ++i) seam[i] = mesh.add(mirrored(shoulder_seam[i], side), Region::torso, side);
    const gown::Armhole armhole = sew_shoulder(mesh, bodice_charts, side, low, high, seam, t);
    add_sleeve(mesh, side, around(armhole, gown::armhole_places), sleeve_rows, 6, 0.14f);
}

}  // namespace

void add_stola(Mesh &mesh)
{
    constexpr size_t waist = 6;  // from here up the surface is the bodice
    std::vector<Ring> rings;
    std::vector<float> heights;
    for (const Row &row : rows) rings.push_back(add_row(mesh, row)), heights.push_back(row.y);
    rings.push_back(add_row(mesh, bust)), heights.push_back(1.290f);
    rings.push_back(add_row(mesh, armpit)), heights.push_back(1.365f);
    for (size_t r = 0; r + 1 < rings.size(); ++r)
        sew_rows(mesh, r < waist ? gown::Charts{gown_front, gown_back} : bodice_charts, rings[r], rings[r + 1],
                 {heights[r], heights[r + 1]});
    const uint32_t inside = mesh.add(glm::vec3(0, 0.30f, 0), heavy_cloth);
    mesh.fan(gown_inside, Winding::reversed, doubled(mesh, span(rings[0], 0, columns + 1, 0)),
             {inside, glm::vec2(-1, 1)});
    const Ring high = add_row(mesh, upper);
    constexpr float t = 1.440f;
    sew_yoke(mesh, bodice_charts, rings.back(), high, {heights.back(), t});
    for (const Side side : {Side::left, Side::right}) add_shoulder(mesh, side, rings.back(), high, t);
}

}  // namespace claque::figures::patrician
