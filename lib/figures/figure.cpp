#include "lib/figures/figure.h"

#include "lib/figures/assemble.h"
#include "lib/figures/clips/variant.h"
#include "lib/figures/decurion/decurion.h"
#include "lib/figures/parts.h"
#include "lib/figures/texture_variants.h"

namespace claque::figures
{

namespace
{

void add_citizen(Mesh &mesh)
{
    add_head(mesh);
    add_tunic(mesh);
    for (const Side side : {Side::left, Side::right}) {
        add_arm(mesh, side);
        add_leg(mesh, side);
    }
}

// The face has the largest area: about 1.3 mm per texel.
const Layout &citizen_layout()
{
    static const Layout layout = {
        {Chart::head, {0, 0, 304, 240}},
        {Chart::ear, {304, 216, 52, 24}},
        {Chart::ear_r, {356, 216, 52, 24}},
        {Chart::tunic_front, {0, 240, 176, 272}},
        {Chart::tunic_back, {176, 240, 152, 272}},
        {Chart::tunic_inside, {328, 484, 184, 28}},
        {Chart::sleeve, {304, 172, 104, 44}},
        {Chart::sleeve_r, {408, 172, 104, 44}},
        {Chart::sleeve_inside, {408, 216, 52, 24}},
        {Chart::sleeve_inside_r, {460, 216, 52, 24}},
        {Chart::arm, {304, 112, 104, 60}},
        {Chart::arm_r, {408, 112, 104, 60}},
        {Chart::hand_back, {304, 0, 104, 56}},
        {Chart::hand_back_r, {408, 0, 104, 56}},
        {Chart::hand_palm, {304, 56, 104, 56}},
        {Chart::hand_palm_r, {408, 56, 104, 56}},
        {Chart::leg, {328, 240, 92, 104}},
        {Chart::leg_r, {420, 240, 92, 104}},
        {Chart::foot, {328, 344, 76, 140}},
        {Chart::foot_r, {404, 344, 76, 140}},
        {Chart::sole, {480, 344, 16, 140}},
        {Chart::sole_r, {496, 344, 16, 140}},
    };
    return layout;
}

Zones citizen_zones()
{
    return {
        {Zone::skin, {0.86f, 0.65f, 0.52f}, {16, 28, 0.34f, 0.52f, 0.58f, 0.95f}},
        {Zone::hair, {0.33f, 0.23f, 0.16f}, {12, 38, 0.15f, 0.62f, 0.12f, 0.52f}},
        {Zone::eyes, {0.93f, 0.91f, 0.87f}, {20, 220, 0.02f, 0.12f, 0.88f, 1.00f}},
        {Zone::lips, {0.74f, 0.45f, 0.40f}, {4, 15, 0.38f, 0.50f, 0.55f, 0.78f}},
        {Zone::tunic, {0.93f, 0.88f, 0.77f}, {12, 54, 0.04f, 0.52f, 0.58f, 1.00f}},
        {Zone::belt, {0.42f, 0.26f, 0.15f}, {12, 34, 0.40f, 0.72f, 0.24f, 0.55f}},
        {Zone::border, {0.60f, 0.16f, 0.14f}, {330, 36, 0.50f, 0.82f, 0.30f, 0.68f}},
        {Zone::sandals, {0.47f, 0.30f, 0.18f}, {14, 36, 0.40f, 0.70f, 0.28f, 0.58f}},
    };
}

}  // namespace

model::Model citizen()
{
    Figure figure;
    figure.name = "citizen";
    figure.add_pieces = add_citizen;
    figure.painter = paint_citizen;
    figure.texture_sets = {{"bearded", paint_bearded_citizen}};
    figure.layout = citizen_layout();
    figure.zones = citizen_zones();
    figure.clips = figure_clips();
    return assemble(figure);
}

void add_variants(model::Model &person, uint32_t clip_count)
{
    add_variants(person.rig, clip_count, person.name == "decurion" ? decurion::keep_clear : nullptr);
}

const std::vector<Builtin> &people()
{
    static const std::vector<Builtin> all = {
        {"citizen", citizen}, {"patrician", patrician_woman}, {"decurion", decurion_man}, {"plebeian", plebeian_man}};
    return all;
}

const std::vector<Builtin> &builtins()
{
    static const std::vector<Builtin> all = [] {
        std::vector<Builtin> made = people();
        made.push_back({"herald", winged_herald});
        made.push_back({"owl", letter_owl});
        return made;
    }();
    return all;
}

}  // namespace claque::figures
