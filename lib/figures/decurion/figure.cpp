// The decurion's zones, layout, weights and definition.
#include "lib/figures/figure.h"

#include <algorithm>

#include "lib/figures/assemble.h"
#include "lib/figures/brush.h"
#include "lib/figures/decurion/decurion.h"
#include "lib/figures/decurion/paint.h"
#include "lib/figures/texture_variants.h"

namespace claque::figures
{

namespace
{

using namespace decurion;

void add_pieces(Mesh &mesh)
{
    add_aged_head(mesh);
    add_toga(mesh);
    add_balteus(mesh);
    add_limbs(mesh);
}

BoneWeights weigh(const Point &point)
{
    BoneWeights w{};
    glm::vec3 p = point.position;
    if (point.region == skirts) {
        const glm::vec3 place = p;
        p.x *= 1 + 0.9f * smoothstep(0.45f, 0.25f, p.y);  // each half follows its own shin, except for a narrow strip
        // In front the hem rests on the toes when the shins lean; behind, a sitter's thighs draw the cloth up to them.
        const float toes = 0.45f * smoothstep(0.25f, 0.115f, place.y) * smoothstep(0.06f, 0.16f, place.z);
        const float drawn = 0.13f * smoothstep(-0.02f, -0.12f, place.z);
        const float left = smoothstep(-0.13f, 0.13f, p.x);
        weigh_gown(w, p, 1 - toes - drawn);
        add_weight(w, Bone::toes, toes * left);
        add_weight(w, Bone::toes_r, toes * (1 - left));
        add_weight(w, Bone::skirt_back, drawn * left);
        add_weight(w, Bone::skirt_back_r, drawn * (1 - left));
        return w;
    }
    constexpr float body = 0.195f;  // where cloth covers it, the body counts as no wider
    p.x = std::clamp(p.x, -body, body);
    weigh_shoulder(w, p, p.x >= 0 ? Side::left : Side::right, 1);
    return w;
}

const Layout &decurion_layout()
{
    static const Layout layout = {
        {Chart::head, {0, 0, 304, 240}},
        {Chart::hand_back, {304, 0, 104, 54}},
        {Chart::hand_back_r, {408, 0, 104, 54}},
        {Chart::hand_palm, {304, 54, 104, 54}},
        {Chart::hand_palm_r, {408, 54, 104, 54}},
        {Chart::arm, {304, 108, 104, 52}},
        {Chart::arm_r, {408, 108, 104, 52}},
        {Chart::sleeve, {304, 160, 104, 52}},
        {Chart::sleeve_r, {408, 160, 104, 52}},
        {Chart::ear, {304, 212, 44, 28}},
        {Chart::ear_r, {348, 212, 44, 28}},
        {Chart::sleeve_inside, {392, 212, 60, 28}},
        {Chart::sleeve_inside_r, {452, 212, 60, 28}},
        {toga_front, {0, 240, 144, 272}},
        {toga_back, {144, 240, 116, 272}},
        {chest_front, {260, 240, 126, 112}},
        {chest_back, {386, 240, 126, 112}},
        {decurion::balteus, {260, 352, 252, 56}},
        {Chart::foot, {260, 408, 54, 104}},
        {Chart::foot_r, {314, 408, 54, 104}},
        {Chart::sole, {368, 408, 14, 104}},
        {Chart::sole_r, {382, 408, 14, 104}},
        {umbo, {396, 408, 60, 72}},
        {toga_inside, {396, 480, 116, 32}},
    };
    return layout;
}

Zones decurion_zones()
{
    return {
        {Zone::skin, {0.85f, 0.62f, 0.50f}, {12, 24, 0.34f, 0.50f, 0.66f, 0.94f}},
        {Zone::hair, {0.78f, 0.76f, 0.72f}, {24, 42, 0.02f, 0.26f, 0.34f, 0.98f}},
        {Zone::eyes, {0.92f, 0.89f, 0.84f}, {20, 220, 0.02f, 0.10f, 0.86f, 0.98f}},
        {Zone::lips, {0.70f, 0.42f, 0.37f}, {4, 15, 0.36f, 0.48f, 0.55f, 0.75f}},
        {Zone::tunic, {0.62f, 0.16f, 0.20f}, {215, 45, 0.40f, 0.80f, 0.50f, 0.85f}},
        {Zone::border, {0.50f, 0.10f, 0.36f}, {265, 20, 0.55f, 0.80f, 0.45f, 0.75f}},
        {Zone::sandals, {0.58f, 0.20f, 0.13f}, {0, 26, 0.50f, 0.78f, 0.40f, 0.72f}},
        {Zone::outer, {0.96f, 0.90f, 0.76f}, {338, 58, 0.06f, 0.64f, 0.78f, 1.00f}},
        {Zone::jewellery, {0.96f, 0.78f, 0.30f}, {40, 50, 0.55f, 0.72f, 0.85f, 1.00f}},
    };
}

}  // namespace

model::Model decurion_man()
{
    Figure figure;
    figure.name = "decurion";
    figure.add_pieces = add_pieces;
    figure.painter = paint_decurion;
    figure.texture_sets = {{"bearded", paint_bearded_decurion}};
    figure.layout = decurion_layout();
    figure.zones = decurion_zones();
    figure.clips = figure_clips();
    figure.weigher = weigh;
    figure.fit = decurion::keep_clear;
    return assemble(figure);
}

}  // namespace claque::figures
