// The exomis as twelve columns of cloth from the hem above the knees over the rope to the armpits and shoulders. Bare
// skin on breast and back is the same surface; the edge of the cloth is painted. The left shoulder has a cap sleeve;
// the right one continues into the arm.

#include "lib/figures/brush.h"
#include "lib/figures/gown.h"
#include "lib/figures/plebeian/plebeian.h"
#include "lib/figures/skeleton.h"

namespace claque::figures::plebeian
{

namespace
{

using gown::Armhole, gown::Half, gown::Ring, gown::columns, gown::directions;
constexpr gown::Charts tunic = {Chart::tunic_front, Chart::tunic_back};

// The offset of each column where the cloth falls in folds, as a fraction of the row's fold.
const std::array<float, columns> folds = {
    {-0.8f, 1.0f, -0.7f, 0.9f, -0.8f, 0.9f, -0.7f, 1.0f, -0.9f, 0.8f, -0.6f, 0.9f}};

struct Row {
    float y, side, front, back, ahead, fold, dip;
};

const std::array<Row, 6> rows = {{
    {0.590f, 0.170f, 0.128f, 0.140f, 0.000f, 0.018f, 0.008f},  // hem
    {0.725f, 0.174f, 0.130f, 0.143f, 0.000f, 0.012f, 0.000f},
    {0.880f, 0.167f, 0.122f, 0.146f, 0.000f, 0.008f, 0.000f},  // hips
    {1.056f, 0.142f, 0.106f, 0.104f, 0.000f, 0.000f, 0.000f},  // above the rope, behind the overhang
    {1.040f, 0.155f, 0.122f, 0.117f, 0.000f, 0.012f, 0.014f},  // overhang
    {1.195f, 0.147f, 0.120f, 0.113f, -0.003f, 0.008f, 0.000f},
}};

// The row of the armpits and the row above it, columns 0 to 6; the left side is clothed, the right one bare.
const Half armpit_left = {{{0, 1.338f, 0.112f},
                           {0.072f, 1.338f, 0.124f},
                           {0.136f, 1.346f, 0.074f},
                           {0.152f, 1.336f, -0.006f},
                           {0.138f, 1.352f, -0.088f},
                           {0.070f, 1.362f, -0.124f},
                           {0, 1.362f, -0.116f}}};
const Half armpit_right = {{{0, 0, 0},
                            {0.068f, 1.332f, 0.120f},
                            {0.132f, 1.346f, 0.066f},
                            {0.146f, 1.330f, -0.008f},
                            {0.132f, 1.350f, -0.080f},
                            {0.068f, 1.360f, -0.118f},
                            {0, 0, 0}}};
const Half upper_left = {{neckline[0],
                          neckline[1],
                          {0.152f, 1.410f, 0.054f},
                          {0, 0, 0},  // the armhole
                          {0.154f, 1.410f, -0.070f},
                          neckline[3],
                          neckline[4]}};
const Half upper_right = {
    {{0, 0, 0}, neckline[1], {0.146f, 1.412f, 0.048f}, {0, 0, 0}, {0.150f, 1.412f, -0.064f}, neckline[3], {0, 0, 0}}};
const std::array<glm::vec3, 3> seam_left = {{neckline[2], {0.136f, 1.466f, -0.022f}, {0.176f, 1.454f, -0.016f}}};
const std::array<glm::vec3, 3> seam_right = {{neckline[2], {0.132f, 1.456f, -0.022f}, {0.168f, 1.448f, -0.016f}}};

// Girths: front, back, below, above.
const std::vector<SleeveRow> cap_rows = {{0.100f, {0.060f, 0.060f, 0.066f, 0.052f}},
                                         {0.200f, {0.064f, 0.062f, 0.076f, 0.049f}}};
const SleeveRow deltoid = {0.092f, {0.051f, 0.052f, 0.046f, 0.051f}};

Ring add_row(Mesh &mesh, const Row &row)
{
    Ring ring{};
    for (int k = 0; k < columns; ++k) {
        const glm::vec2 d = directions[half_of<columns>(k)];
        const float fold = 1 + folds[static_cast<size_t>(k)] * row.fold / 0.18f;
        const float y = row.y + row.dip * folds[static_cast<size_t>((k + 5) % columns)];
        const glm::vec3 p(d.x * row.side * fold, y, row.ahead + d.y * (d.y > 0 ? row.front : row.back) * fold);
        ring[static_cast<size_t>(k)] = mesh.add(mirrored(p, side_of<columns>(k)),
                                                row.y < 1.03f ? short_skirt : Region::torso, side_of<columns>(k));
    }
    return ring;
}

// The head's point at this position, if there is one, so that bare skin shows no edge.
uint32_t shared(Mesh &mesh, glm::vec3 p, Side side)
{
    for (uint32_t i = 0; i < mesh.points.size(); ++i)
        if (mesh.points[i].position == p) return i;
    return mesh.add(p, Region::torso, side);
}

Ring add_row(Mesh &mesh, const Half &left, const Half &right)
{
    Ring ring{};
    for (int k = 0; k < columns; ++k) {
        const glm::vec3 p = (side_of<columns>(k) == Side::left ? left : right)[half_of<columns>(k)];
        if (p.y > 0) ring[static_cast<size_t>(k)] = shared(mesh, mirrored(p, side_of<columns>(k)), side_of<columns>(k));
    }
    return ring;
}

Ring twin(Mesh &mesh, const Ring &ring)
{
    Ring made{};
    const Chain chain = doubled(mesh, span(ring, 0, columns, 0));
    for (size_t k = 0; k < made.size(); ++k) made[k] = chain[k].point;
    return made;
}

void add_cap_sleeve(Mesh &mesh, const Armhole &armhole)
{
    add_sleeve(mesh, Side::left, around(armhole, gown::armhole_places), cap_rows, 6, 0.13f);
    add_arm(mesh, Side::left);
}

void add_bare_shoulder(Mesh &mesh, const Armhole &armhole)
{
    const glm::vec3 shoulder = skeleton().joint(Bone::upper_arm);
    const Chain muscle =
        ring_chain(add_ring(mesh, Region::sleeve, Side::right, 6, shoulder + arm_direction() * deltoid.along,
                            -arm_dorsal(), arm_thumbward(), deltoid.girth),
                   -deltoid.along);
    mesh.sew(Chart::sleeve_r, winding_of(Side::right), around(armhole, gown::armhole_places), muscle, Along::s);
    // The arm begins with a ring of six.
    const uint32_t first = static_cast<uint32_t>(mesh.points.size());
    add_arm(mesh, Side::right);
    const Chain arm = ring_chain({first, first + 1, first + 2, first + 3, first + 4, first + 5}, -0.170f);
    mesh.sew(Chart::sleeve_r, winding_of(Side::right), muscle, arm, Along::s);
}

// From the row of the armpits, at height `t` of the charts, to the top of the shoulder; returns the armhole.
Armhole add_shoulder(Mesh &mesh, Side side, const Ring &low, const Ring &high, float t)
{
    std::array<uint32_t, 3> seam{};
    for (size_t i = 0; i < 3; ++i)
        seam[i] = shared(mesh, mirrored((side == Side::left ? seam_left : seam_right)[i], side), side);
    return sew_shoulder(mesh, tunic, side, low, high, seam, t);
}

}  // namespace

BoneWeights weigh_skirt(const Point &point)
{
    const glm::vec3 p = point.position;
    const Side side = p.x >= 0 ? Side::left : Side::right;
    const float out = smoothstep(0.05f, 0.15f, std::fabs(p.x)), down = smoothstep(0.96f, 0.80f, p.y);
    const float with_thigh = 0.88f * out * down;
    BoneWeights w{};
    weigh_gown(w, p, 1 - with_thigh);
    add_weight(w, on(side, Bone::thigh), with_thigh);
    return w;
}

void add_exomis(Mesh &mesh)
{
    std::vector<Ring> rings;
    std::vector<float> heights;
    float t = 0.59f;
    for (size_t r = 0; r < rows.size(); ++r) {
        rings.push_back(add_row(mesh, rows[r]));
        if (r > 0) t += rows[r].y > rows[r - 1].y ? rows[r].y - rows[r - 1].y : 0.02f;
        heights.push_back(t);
    }
    rings.push_back(add_row(mesh, armpit_left, armpit_right));
    heights.push_back(t += 0.15f);
    constexpr size_t fold = 3;  // from here the overhang falls to its lip, the next row, with a sharp edge at both
    for (size_t r = 0; r + 1 < rings.size(); ++r)
        sew_rows(mesh, tunic, r == fold || r == fold + 1 ? twin(mesh, rings[r]) : rings[r], rings[r + 1],
                 {heights[r], heights[r + 1]});
    const uint32_t inside = mesh.add(glm::vec3(0, 0.82f, 0), short_skirt);
    mesh.fan(Chart::tunic_inside, Winding::reversed, doubled(mesh, span(rings[0], 0, columns + 1, 0)),
             {inside, glm::vec2(-1, 1)});
    const Ring &low = rings.back(), high = add_row(mesh, upper_left, upper_right);
    const float top = t + 0.075f;
    sew_yoke(mesh, tunic, low, high, {t, top});
    add_cap_sleeve(mesh, add_shoulder(mesh, Side::left, low, high, top));
    add_bare_shoulder(mesh, add_shoulder(mesh, Side::right, low, high, top));
}

}  // namespace claque::figures::plebeian
