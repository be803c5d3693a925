#include "lib/figures/patrician/paint.h"

#include <glm/geometric.hpp>

#include "lib/figures/brush.h"
#include "lib/figures/patrician/patrician.h"
#include "lib/figures/skeleton.h"

namespace claque::figures
{

namespace patrician
{

namespace
{

// The shared painters expect hands and feet of the citizen's size.
Texel grown(Texel t, Bone joint, float size, float size_y)
{
    const glm::vec3 centre = skeleton().joint(joint);
    const glm::vec3 d = mirrored(t.position, t.side) - centre;
    t.position = mirrored(glm::vec3(centre.x + d.x / size, centre.y + d.y / size_y, centre.z + d.z / size), t.side);
    return t;
}

Paint arm_with_bracelet(const Texel &t)
{
    const glm::vec3 from = mirrored(t.position, t.side) - skeleton().joint(Bone::upper_arm);
    const float along = glm::dot(from, arm_direction());
    if (along > 0.492f && along < 0.520f) {
        const float bead = spot(along - 0.506f, 0.010f);
        return {190 + 60 * bead - 70 * spot(along - 0.497f, 0.003f) - 70 * spot(along - 0.515f, 0.003f),
                Zone::jewellery};
    }
    Paint paint = paint_limb(t);
    paint.luminance = 232 + 0.6f * (paint.luminance - 226);  // softer than the shared skin
    return paint;
}

Paint earring_of(const Texel &t)
{
    const float down = 1.590f - t.position.y;
    const float g = down < 0.008f ? 150 : 200 + 50 * spot(down - 0.022f, 0.010f);
    return {g, Zone::jewellery};
}

Paint plain(const Texel &t)
{
    switch (t.chart) {
        case Chart::head:
        case Chart::ear:
        case Chart::ear_r:
            return paint_lady_head(t);
        case Chart::arm:
        case Chart::arm_r:
            return arm_with_bracelet(t);
        case Chart::hand_back:
        case Chart::hand_back_r:
        case Chart::hand_palm:
        case Chart::hand_palm_r: {
            Paint paint = paint_hand(grown(t, Bone::hand, hand_size, hand_size));
            paint.luminance = 230 + 0.8f * (paint.luminance - 226);
            return paint;
        }
        case Chart::foot:
        case Chart::foot_r:
        case Chart::sole:
        case Chart::sole_r:
            return paint_foot(grown(t, Bone::foot, foot_size, 1));
        default:
            break;
    }
    if (t.chart == bun) return paint_bun(t);
    if (t.chart == palla) return paint_palla(t);
    if (t.chart == earring || t.chart == on(Side::right, earring)) return earring_of(t);
    return is_mantle(t) ? paint_mantle(t) : paint_stola(t);
}

}  // namespace

}  // namespace patrician

Paint paint_patrician(const Texel &t)
{
    Paint paint = patrician::plain(t);
    // The roots of the fingers lie inside the palm, and earrings beside the neck; ambient occlusion would blacken them
    // there.
    const bool hand = t.chart >= Chart::hand_back && t.chart <= Chart::hand_palm_r;
    const bool ring = paint.zone == Zone::jewellery;
    const float open = hand || ring ? std::max(t.ambient_visibility, 0.75f) : t.ambient_visibility;
    const float shade = 0.52f + 0.48f * smoothstep(0.05f, 0.92f, open);
    paint.luminance *= paint.zone == Zone::eyes ? 0.5f + 0.5f * shade : shade;
    return paint;
}

}  // namespace claque::figures
