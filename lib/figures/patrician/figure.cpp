// The patrician's zones, layout and definition.
#include "lib/figures/figure.h"

#include "lib/figures/assemble.h"
#include "lib/figures/patrician/paint.h"
#include "lib/figures/patrician/patrician.h"
#include "lib/figures/texture_variants.h"

namespace claque::figures
{

namespace
{

using namespace patrician;

void add_patrician(Mesh &mesh)
{
    add_lady_head(mesh);
    add_stola(mesh);
    add_palla(mesh);
    add_limbs(mesh);
}

const Layout &patrician_layout()
{
    static const Layout layout = {
        {Chart::head, {0, 0, 288, 232}},
        {Chart::hand_back, {288, 0, 112, 52}},
        {Chart::hand_back_r, {400, 0, 112, 52}},
        {Chart::hand_palm, {288, 52, 112, 52}},
        {Chart::hand_palm_r, {400, 52, 112, 52}},
        {Chart::arm, {288, 104, 112, 56}},
        {Chart::arm_r, {400, 104, 112, 56}},
        {Chart::sleeve, {288, 160, 112, 40}},
        {Chart::sleeve_r, {400, 160, 112, 40}},
        {Chart::ear, {288, 200, 44, 32}},
        {Chart::ear_r, {332, 200, 44, 32}},
        {Chart::sleeve_inside, {376, 200, 44, 16}},
        {Chart::sleeve_inside_r, {376, 216, 44, 16}},
        {earring, {420, 200, 46, 32}},
        {on(Side::right, earring), {466, 200, 46, 32}},
        {gown_front, {0, 232, 140, 280}},
        {gown_back, {140, 232, 130, 280}},
        {bodice_front, {270, 232, 121, 112}},
        {bodice_back, {391, 232, 121, 112}},
        {patrician::palla, {270, 344, 242, 64}},
        {Chart::foot, {270, 408, 54, 104}},
        {Chart::foot_r, {324, 408, 54, 104}},
        {Chart::sole, {378, 408, 14, 104}},
        {Chart::sole_r, {392, 408, 14, 104}},
        {bun, {406, 408, 72, 72}},
        {gown_inside, {406, 480, 106, 32}},
    };
    return layout;
}

Zones patrician_zones()
{
    return {
        {Zone::skin, {0.93f, 0.75f, 0.63f}, {16, 27, 0.32f, 0.46f, 0.74f, 1.00f}},
        {Zone::hair, {0.36f, 0.22f, 0.13f}, {14, 38, 0.38f, 0.70f, 0.20f, 0.64f}},
        {Zone::eyes, {0.95f, 0.93f, 0.90f}, {20, 220, 0.02f, 0.10f, 0.92f, 1.00f}},
        {Zone::lips, {0.80f, 0.38f, 0.36f}, {350, 10, 0.46f, 0.62f, 0.66f, 0.86f}},
        {Zone::tunic, {0.62f, 0.24f, 0.30f}, {196, 76, 0.40f, 0.62f, 0.62f, 0.90f}},
        {Zone::belt, {0.85f, 0.62f, 0.20f}, {30, 60, 0.50f, 0.80f, 0.50f, 0.86f}},
        {Zone::border, {0.90f, 0.66f, 0.22f}, {332, 48, 0.45f, 0.78f, 0.42f, 0.80f}},
        {Zone::sandals, {0.70f, 0.42f, 0.24f}, {8, 44, 0.45f, 0.72f, 0.40f, 0.75f}},
        {Zone::outer, {0.24f, 0.34f, 0.62f}, {318, 262, 0.46f, 0.78f, 0.45f, 0.70f}},
        {Zone::jewellery, {0.96f, 0.78f, 0.30f}, {40, 50, 0.55f, 0.72f, 0.88f, 1.00f}},
    };
}

}  // namespace

model::Model patrician_woman()
{
    Figure figure;
    figure.name = "patrician";
    figure.add_pieces = add_patrician;
    figure.painter = paint_patrician;
    figure.texture_sets = {{"banded", paint_banded_patrician}};
    figure.layout = patrician_layout();
    figure.zones = patrician_zones();
    figure.weigher = weigh_heavy_cloth;
    figure.clips = figure_clips();
    return assemble(figure);
}

}  // namespace claque::figures
