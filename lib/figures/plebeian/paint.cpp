// Chooses the plebeian's painter for each chart and applies ambient occlusion.
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
    // The roots of the fingers lie inside the palm; ambient occlusion would blacken the hands there.
    const bool hand = t.chart >= Chart::hand_back && t.chart <= Chart::hand_palm_r;
    const float open = hand ? std::max(t.ambient_visibility, 0.72f) : t.ambient_visibility;
    // Raised arms uncover cloth that they shade in the rest pose, so cloth gets less shadow than skin.
    const float deepest = paint.zone == Zone::tunic ? 0.74f : 0.60f;
    const float shade = deepest + (1 - deepest) * smoothstep(0.05f, 0.90f, open);
    paint.luminance *= paint.zone == Zone::eyes ? 0.5f + 0.5f * shade : shade;
    return paint;
}

}  // namespace claque::figures
