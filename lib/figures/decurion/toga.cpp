// The toga round the body and the visible tunic: twelve columns of cloth from the shins over the fold in front of the
// thighs, the belly and the armpits to the yoke. On the left the toga covers shoulder and upper arm.
#include <algorithm>

#include "lib/figures/brush.h"
#include "lib/figures/decurion/decurion.h"
#include "lib/figures/gown.h"
#include "lib/figures/skeleton.h"

namespace claque::figures::decurion
{

namespace
{

using gown::Ring, gown::add_row, gown::directions;

const std::array<float, columns> folds = {
    {-0.7f, 1.2f, -0.7f, 0.9f, -0.8f, 1.0f, -0.8f, 0.9f, -0.7f, 0.9f, -0.8f, 0.8f}};

// Half widths of the body and its cloth by height; the belly is widest a hand below the waist.
struct Girths {
    float y, side, front, back, fold;
};
const std::array<Girths, 11> girths = {{
    {0.115f, 0.222f, 0.190f, 0.184f, 0.042f},
    {0.250f, 0.207f, 0.170f, 0.178f, 0.034f},
    {0.390f, 0.196f, 0.152f, 0.166f, 0.024f},
    {0.490f, 0.194f, 0.150f, 0.166f, 0.016f},
    {0.640f, 0.200f, 0.160f, 0.172f, 0.010f},
    {0.780f, 0.210f, 0.176f, 0.180f, 0.008f},
    {0.900f, 0.215f, 0.204f, 0.176f, 0.006f},
    {1.000f, 0.213f, 0.219f, 0.162f, 0.004f},
    {1.080f, 0.205f, 0.212f, 0.148f, 0.002f},
    {1.160f, 0.191f, 0.186f, 0.138f, 0.000f},
    {1.230f, 0.178f, 0.154f, 0.130f, 0.000f},
}};

const gown::Half breast = {{{0, 1.282f, 0.132f},
                            {0.076f, 1.280f, 0.138f},
                            {0.140f, 1.280f, 0.084f},
                            {0.165f, 1.282f, -0.006f},
                            {0.142f, 1.286f, -0.086f},
                            {0.078f, 1.290f, -0.126f},
                            {0, 1.290f, -0.122f}}};
const gown::Half armpit = {{{0, 1.345f, 0.118f},
                            {0.072f, 1.345f, 0.126f},
                            {0.146f, 1.350f, 0.066f},
                            {0.162f, 1.340f, -0.006f},
                            {0.148f, 1.354f, -0.082f},
                            {0.070f, 1.364f, -0.130f},
                            {0, 1.364f, -0.128f}}};
const gown::Half upper = {{neckline[0],
                           neckline[1],
                           {0.164f, 1.410f, 0.056f},
                           {0, 0, 0},  // the armhole
                           {0.166f, 1.412f, -0.072f},
                           neckline[3],
                           neckline[4]}};
const std::array<glm::vec3, 3> shoulder_seam = {{neckline[2], {0.138f, 1.466f, -0.022f}, {0.180f, 1.456f, -0.016f}}};

// Girths: front, back, below, above.
const std::vector<SleeveRow> tunic_sleeve = {{0.098f, {0.064f, 0.064f, 0.074f, 0.055f}},
                                             {0.245f, {0.074f, 0.072f, 0.088f, 0.053f}}};
const std::vector<SleeveRow> toga_sleeve = {{0.105f, {0.076f, 0.080f, 0.086f, 0.066f}},
                                            {0.215f, {0.090f, 0.096f, 0.112f, 0.066f}},
                                            {0.325f, {0.094f, 0.104f, 0.138f, 0.060f}}};

constexpr gown::Charts chest = {chest_front, chest_back};

Girths girths_at(float y)
{
    for (size_t i = 1; i < girths.size(); ++i)
        if (y <= girths[i].y) {
            const Girths &a = girths[i - 1], &b = girths[i];
            const float t = (y - a.y) / (b.y - a.y);
            return {y, a.side + (b.side - a.side) * t, a.front + (b.front - a.front) * t,
                    a.back + (b.back - a.back) * t, a.fold + (b.fold - a.fold) * t};
        }
    return girths.back();
}

glm::vec3 on_cloth(int column, float y, float out)
{
    const Girths g = girths_at(y);
    glm::vec2 d = directions[half_of<columns>(column)];
    // Towards the hem two columns come together in front of the shins, which would otherwise penetrate the cloth
    // between them.
    if (half_of<columns>(column) == 1) d += glm::vec2(-0.31f, 0.08f) * smoothstep(0.49f, 0.20f, y);
    const float fold = folds[static_cast<size_t>(column)] * g.fold + out;
    return mirrored(glm::vec3(d.x * (g.side + fold), y, d.y * ((d.y > 0 ? g.front : g.back) + fold)),
                    side_of<columns>(column));
}

template <class HeightAndOut>
Ring add_row(Mesh &mesh, HeightAndOut at)
{
    Ring ring{};
    for (int k = 0; k < columns; ++k) {
        const SinusEdge e = at(static_cast<size_t>(k));
        ring[static_cast<size_t>(k)] = mesh.add(on_cloth(k, e.y, e.out),
                                                e.y < 0.45f   ? skirts
                                                : e.y < 1.03f ? Region::gown
                                                              : wrap,
                                                side_of<columns>(k));
    }
    return ring;
}

void add_shoulder(Mesh &mesh, Side side, const Ring &low, const Ring &high, float t)
{
    std::array<uint32_t, 3> seam{};
    for (size_t i = 0; i < 3; ++i) seam[i] = mesh.add(mirrored(shoulder_seam[i], side), Region::torso, side);
    const gown::Armhole armhole = sew_shoulder(mesh, chest, side, low, high, seam, t);
    add_sleeve(mesh, side, around(armhole, gown::armhole_places), side == Side::left ? toga_sleeve : tunic_sleeve, 6,
               0.14f);
}

}  // namespace

void add_toga(Mesh &mesh)
{
    const auto level = [](float y) { return [y](size_t) { return SinusEdge{y, 0}; }; };
    // The cloth below starts behind the fold, a little higher than its edge.
    const auto behind = [](size_t k) {
        return SinusEdge{sinus[k].y - 0.055f + 0.067f * std::min(1.0f, sinus[k].out / 0.030f), -0.006f};
    };
    const auto edge = [](size_t k) { return sinus[k]; };
    const auto above = [](size_t k) { return SinusEdge{0.900f + 0.10f * (sinus[k].y - 0.70f), 0.4f * sinus[k].out}; };
    std::vector<Ring> rings;
    std::vector<float> heights = {0.115f, 0.250f, 0.390f, 0.490f, 0.600f, 0.660f, 0.880f, 1.030f, 1.040f};
    for (const float y : {0.115f, 0.250f, 0.390f, 0.490f}) rings.push_back(add_row(mesh, level(y)));
    rings.push_back(add_row(mesh, behind));
    rings.push_back(add_row(mesh, edge));
    rings.push_back(add_row(mesh, above));
    rings.push_back(add_row(mesh, level(1.040f)));
    const size_t waist = rings.size() - 1;
    heights.resize(rings.size());
    rings.push_back(add_row(mesh, level(1.165f))), heights.push_back(1.165f);
    rings.push_back(add_row(mesh, breast)), heights.push_back(1.290f);
    rings.push_back(add_row(mesh, armpit)), heights.push_back(1.365f);
    for (size_t r = 0; r + 1 < rings.size(); ++r)
        sew_rows(mesh, r < waist ? gown::Charts{toga_front, toga_back} : chest, rings[r], rings[r + 1],
                 {heights[r], heights[r + 1]});
    const uint32_t inside = mesh.add(glm::vec3(0, 0.36f, 0), skirts);
    mesh.fan(toga_inside, Winding::reversed, doubled(mesh, span(rings[0], 0, columns + 1, 0)),
             {inside, glm::vec2(-1, 1)});
    const Ring high = add_row(mesh, upper);
    constexpr float t = 1.440f;
    sew_yoke(mesh, chest, rings.back(), high, {heights.back(), t});
    for (const Side side : {Side::left, Side::right}) add_shoulder(mesh, side, rings.back(), high, t);
}

}  // namespace claque::figures::decurion
