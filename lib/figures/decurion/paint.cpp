#include "lib/figures/decurion/paint.h"

#include <glm/geometric.hpp>

#include "lib/figures/brush.h"
#include "lib/figures/decurion/decurion.h"
#include "lib/figures/skeleton.h"

namespace claque::figures
{

namespace decurion
{

namespace
{

// A signet ring on the ring finger, and more prominent veins and knuckles than a young man's.
Paint old_hand(const Texel &t)
{
    const glm::vec3 from = mirrored(t.position, t.side) - skeleton().joint(Bone::hand);
    const glm::vec2 at(glm::dot(from, arm_direction()), from.z);
    const bool back = t.chart == Chart::hand_back || t.chart == Chart::hand_back_r;
    const bool finger = t.region != Region::thumb && t.region != Region::index;
    const float narrow = 1 - 1.6f * (at.x - 0.09f);
    if (finger && at.x > 0.098f && at.x < 0.110f && at.y > -0.0215f * narrow && at.y < -0.0015f * narrow) {
        const glm::vec2 bezel = at - glm::vec2(0.104f, -0.0115f * narrow);
        const float out = std::sqrt(bezel.x * bezel.x + bezel.y * bezel.y);
        if (back && out < 0.0055f) return {out < 0.0030f ? 150.0f : 255.0f, Zone::jewellery};
        return {235 - 60 * spot(std::fabs(at.x - 0.104f) - 0.006f, 0.003f), Zone::jewellery};
    }
    Paint paint = paint_hand(t);
    if (back && paint.zone == Zone::skin && at.x < 0.086f && at.x > 0.01f)
        for (const float vein : {-0.022f, -0.002f, 0.018f})
            paint.luminance -=
                16 * spot(at.y - vein * (0.4f + 5 * at.x) - 0.004f * (value_noise(at.x * 60, vein * 900, 301) - 0.5f),
                          0.0030f);
    return paint;
}

Paint plain(const Texel &t)
{
    switch (t.chart) {
        case Chart::head:
        case Chart::ear:
        case Chart::ear_r:
            return paint_aged_head(t);
        case Chart::arm:
        case Chart::arm_r:
            return paint_limb(t);
        case Chart::hand_back:
        case Chart::hand_back_r:
        case Chart::hand_palm:
        case Chart::hand_palm_r:
            return old_hand(t);
        case Chart::foot:
        case Chart::foot_r:
        case Chart::sole:
        case Chart::sole_r:
            return paint_shoe(t);
        default:
            break;
    }
    if (t.chart == balteus || t.chart == umbo) return paint_balteus(t);
    return is_toga(t) ? paint_toga(t) : paint_tunic(t);
}

}  // namespace

}  // namespace decurion

Paint paint_decurion(const Texel &t)
{
    Paint paint = decurion::plain(t);
    // The roots of the fingers lie inside the palm; ambient occlusion would blacken the hands there.
    const bool hand = t.chart >= Chart::hand_back && t.chart <= Chart::hand_palm_r;
    const bool loose = t.chart == decurion::balteus || t.chart == decurion::umbo;  // their edges lie inside the dress
    const float open = std::max(t.ambient_visibility, hand                          ? 0.74f
                                                      : paint.zone == Zone::sandals ? 0.5f
                                                      : loose                       ? 0.35f
                                                                                    : 0.0f);
    const float shade = 0.54f + 0.46f * smoothstep(0.05f, 0.90f, open);
    paint.luminance *= paint.zone == Zone::eyes ? 0.5f + 0.5f * shade : shade;
    return paint;
}

}  // namespace claque::figures
