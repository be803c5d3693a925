#include "lib/figures/brush.h"
#include "lib/figures/plebeian/plebeian.h"

namespace claque::figures
{

namespace
{

Paint plain(const Texel &t)
{
    switch (t.chart) {
        case Chart::head:
        case Chart::ear:
        case Chart::ear_r:
            return plebeian::paint_lean_head(t);
        case Chart::arm:
        case Chart::arm_r:
        case Chart::leg:
        case Chart::leg_r:
            return paint_limb(t);
        case Chart::hand_back:
        case Chart::hand_back_r:
        case Chart::hand_palm:
        case Chart::hand_palm_r:
            return paint_hand(t);
        case Chart::foot:
        case Chart::foot_r:
        case Chart::sole:
        case Chart::sole_r:
            return paint_foot(t);
        default:
            return t.chart == plebeian::cloak ? plebeian::paint_cloak(t) : plebeian::paint_exomis(t);
    }
}

}  // namespace

Paint paint_plebeian(const Texel &t)
{
    Paint paint = plain(t);
    // The roots of the fingers lie inside the palm, where nothing is open: no soot on hands.
    const bool hand = t.chart >= Chart::hand_back && t.chart <= Chart::hand_palm_r;
    const float open = hand ? std::max(t.ambient_visibility, 0.72f) : t.ambient_visibility;
    // Cloth is seen where the arms covered it when they rise: less shadow there than skin may have.
    const float deepest = paint.zone == Zone::tunic ? 0.74f : 0.60f;
    const float shade = deepest + (1 - deepest) * smoothstep(0.05f, 0.90f, open);
    paint.luminance *= paint.zone == Zone::eyes ? 0.5f + 0.5f * shade : shade;
    return paint;
}

}  // namespace claque::figures
