// The plebeian's zones, layout and definition.
#include "lib/figures/figure.h"

#include "lib/figures/assemble.h"
#include "lib/figures/plebeian/plebeian.h"
#include "lib/figures/texture_variants.h"

namespace claque::figures
{

namespace
{

void add_plebeian(Mesh &mesh)
{
    plebeian::add_lean_head(mesh);
    plebeian::add_exomis(mesh);
    plebeian::add_cloak(mesh);
    for (const Side side : {Side::left, Side::right}) plebeian::add_bare_leg(mesh, side);
}

const Layout &plebeian_layout()
{
    static const Layout layout = {
        {Chart::head, {0, 0, 304, 240}},          {Chart::hand_back, {304, 0, 104, 56}},
        {Chart::hand_back_r, {408, 0, 104, 56}},  {Chart::hand_palm, {304, 56, 104, 56}},
        {Chart::hand_palm_r, {408, 56, 104, 56}}, {Chart::arm, {304, 112, 104, 60}},
        {Chart::arm_r, {408, 112, 104, 60}},      {Chart::sleeve, {304, 172, 104, 44}},
        {Chart::sleeve_r, {408, 172, 104, 68}},   {Chart::sleeve_inside, {304, 216, 32, 24}},
        {Chart::ear, {336, 216, 36, 24}},         {Chart::ear_r, {372, 216, 36, 24}},
        {Chart::tunic_front, {0, 240, 168, 220}}, {Chart::tunic_back, {168, 240, 152, 220}},
        {plebeian::cloak, {0, 460, 320, 52}},     {Chart::leg, {320, 240, 96, 112}},
        {Chart::leg_r, {416, 240, 96, 112}},      {Chart::foot, {320, 352, 78, 132}},
        {Chart::foot_r, {398, 352, 78, 132}},     {Chart::sole, {476, 352, 18, 132}},
        {Chart::sole_r, {494, 352, 18, 132}},     {Chart::tunic_inside, {320, 484, 192, 28}},
    };
    return layout;
}

// Sunburnt skin, undyed and homespun wool: browns, greys, dull ochres and greens.
Zones plebeian_zones()
{
    return {
        {Zone::skin, {0.78f, 0.56f, 0.42f}, {16, 28, 0.38f, 0.56f, 0.54f, 0.86f}},
        {Zone::hair, {0.24f, 0.16f, 0.11f}, {14, 36, 0.30f, 0.62f, 0.12f, 0.44f}},
        {Zone::eyes, {0.92f, 0.90f, 0.86f}, {20, 220, 0.02f, 0.10f, 0.88f, 0.98f}},
        {Zone::lips, {0.68f, 0.43f, 0.36f}, {6, 18, 0.36f, 0.48f, 0.54f, 0.74f}},
        {Zone::tunic, {0.60f, 0.53f, 0.43f}, {22, 92, 0.05f, 0.35f, 0.40f, 0.70f}},
        {Zone::belt, {0.60f, 0.50f, 0.34f}, {30, 48, 0.22f, 0.42f, 0.42f, 0.68f}},
        {Zone::border, {0.38f, 0.32f, 0.26f}, {14, 96, 0.08f, 0.35f, 0.35f, 0.56f}},
        {Zone::sandals, {0.38f, 0.27f, 0.18f}, {18, 36, 0.30f, 0.52f, 0.24f, 0.46f}},
        {Zone::outer, {0.43f, 0.42f, 0.36f}, {16, 120, 0.05f, 0.32f, 0.35f, 0.62f}},
    };
}

}  // namespace

model::Model plebeian_man()
{
    Figure figure;
    figure.name = "plebeian";
    figure.add_pieces = add_plebeian;
    figure.painter = paint_plebeian;
    figure.texture_sets = {{"shaven", paint_shaven_plebeian}};
    figure.layout = plebeian_layout();
    figure.zones = plebeian_zones();
    figure.clips = figure_clips();
    figure.weigher = plebeian::weigh_skirt;
    return assemble(figure);
}

}  // namespace claque::figures
