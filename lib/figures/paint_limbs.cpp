// Paints the citizen's arms, hands, legs and sandals.
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include "lib/figures/brush.h"
#include "lib/figures/painters.h"
#include "lib/figures/skeleton.h"

namespace claque::figures
{

namespace
{

// The position on the left limb.
glm::vec3 left_of(const Texel &t) { return mirrored(t.position, t.side); }

Paint arm(const Texel &t)
{
    const glm::vec3 from = left_of(t) - skeleton().joint(Bone::upper_arm);
    const float along = glm::dot(from, arm_direction()), up = glm::dot(from, arm_dorsal()), ahead = from.z;
    float g = 10 * smoothstep(-0.02f, 0.03f, up);
    g -= 24 * spot(along - 0.300f, 0.014f) * smoothstep(0.0f, 0.03f, ahead);  // crook of the elbow
    g -= 20 * spot(glm::vec2(along, up), {0.300f, 0.01f}, {0.025f, 0.02f}) * smoothstep(0, -0.03f, ahead);
    g -= 12 * spot(up + 0.2f * (along - 0.36f), 0.010f) * smoothstep(0.32f, 0.40f, along);  // between the muscles
    g -= 14 * smoothstep(-0.01f, -0.03f, up);
    return {226 + g * smoothstep(0.540f, 0.490f, along), Zone::skin};
}

Paint leg(const Texel &t)
{
    const glm::vec3 p = left_of(t);
    const float x = p.x - 0.092f;
    const bool front = p.z > -0.005f;
    const bool band = (p.y > 0.112f && p.y < 0.128f) || (p.y > 0.166f && p.y < 0.178f);
    const bool tie = front && p.y < 0.178f && std::fabs(x) < 0.0075f;
    if (band || tie) {
        const float edge = std::fabs(x) < 0.010f && front ? 30 : 0;
        return {206 - edge + 30 * value_noise(p.x * 300, p.y * 300, 31), Zone::sandals};
    }
    float g = 224;
    if (front) {
        g -= 15 * spot(to_segment(glm::vec2(x, p.y), {-0.024f, 0.515f}, {-0.020f, 0.455f}), 0.014f);  // round the knee
        g -= 15 * spot(to_segment(glm::vec2(x, p.y), {0.024f, 0.515f}, {0.020f, 0.455f}), 0.014f);
        g -= 24 * spot(glm::vec2(x, p.y), {0, 0.448f}, {0.018f, 0.008f});
        g += 16 * spot(glm::vec2(x, p.y), {0, 0.492f}, {0.020f, 0.026f});
        g += 12 * spot(x + 0.004f, 0.010f) * smoothstep(0.44f, 0.38f, p.y);  // shin
    } else {
        g -= 26 * spot(p.y - 0.488f, 0.012f);                                           // hollow of the knee
        g -= 18 * spot(x - 0.002f, 0.006f) * spot(p.y - 0.32f, 0.09f);                  // between the calf's heads
        g -= 20 * spot(std::fabs(x) - 0.014f, 0.008f) * smoothstep(0.20f, 0.12f, p.y);  // beside the tendon
    }
    g += 14 * spot(glm::vec2(p.y, p.z), {0.098f, -0.016f}, {0.016f, 0.014f}) * smoothstep(0.02f, 0.03f, std::fabs(x));
    g -= 16 * spot(p.y - 0.137f, 0.010f) + 14 * spot(p.y - 0.104f, 0.010f);
    return {g, Zone::skin};
}

}  // namespace

Paint paint_limb(const Texel &t) { return t.chart == Chart::arm || t.chart == Chart::arm_r ? arm(t) : leg(t); }

Paint paint_hand(const Texel &t)
{
    const glm::vec3 from = left_of(t) - skeleton().joint(Bone::hand);
    const glm::vec2 at(glm::dot(from, arm_direction()), from.z);
    const bool back = t.chart == Chart::hand_back || t.chart == Chart::hand_back_r;
    float g = back ? 226 : 226 - 12 * smoothstep(0, 0.04f, at.x);
    const auto nail = [&](glm::vec2 centre, glm::vec2 radii) {
        const float d = spot(at, centre, radii);
        if (back && d > 0.25f) g = 244;
    };
    if (t.region == Region::thumb) {
        nail({0.097f, 0.067f}, {0.010f, 0.009f});
        return {g - 20 * spot(at.x + 0.6f * at.y - 0.108f, 0.006f), Zone::skin};
    }
    if (t.region == Region::index) {
        nail({0.164f, 0.030f}, {0.009f, 0.007f});
        for (const float joint : {0.112f, 0.136f}) g -= 22 * spot(at.x - joint, 0.0045f);
        return {g, Zone::skin};
    }
    if (at.x > 0.086f) {  // three fingers side by side
        const float narrow = 1 - 1.6f * (at.x - 0.09f);
        const float near = std::min(std::fabs(at.y + 0.0215f * narrow), std::fabs(at.y + 0.0015f * narrow));
        g -= 58 * spot(near, 0.0040f) * smoothstep(0.088f, 0.104f, at.x);
        for (const float joint : {0.126f, 0.150f}) g -= 20 * spot(at.x - joint + 0.1f * at.y, 0.0050f);
        nail({0.148f, -0.030f}, {0.008f, 0.007f});
        nail({0.163f, -0.012f}, {0.009f, 0.007f});
        nail({0.170f, 0.006f}, {0.009f, 0.007f});
    }
    if (back) {
        for (const float knuckle : {-0.032f, -0.012f, 0.009f, 0.031f}) {
            g += 14 * spot(at, {0.088f, knuckle}, {0.010f, 0.008f});
            g -= 14 * spot(at.y - knuckle * (0.45f + 5 * at.x), 0.0040f) * spot(at.x - 0.055f, 0.030f);
        }
    } else {
        g -= 30 * spot(to_segment(at, {0.030f, -0.004f}, {0.072f, 0.030f}), 0.0040f);
        g -= 26 * spot(to_segment(at, {0.068f, -0.036f}, {0.080f, 0.020f}), 0.0040f);
    }
    return {g, Zone::skin};
}

Paint paint_foot(const Texel &t)
{
    if (t.chart == Chart::sole || t.chart == Chart::sole_r) return {150, Zone::sandals};
    const glm::vec3 p = left_of(t);
    const float x = p.x - 0.092f - 0.10f * p.z, z = p.z;
    if (p.y < 0.0155f)
        return {178 - 40 * spot(p.y - 0.0155f, 0.003f) + 20 * value_noise(x * 200, z * 200, 41), Zone::sandals};
    const bool heel = z < -0.040f && p.y < 0.050f;
    const bool across_toes = std::fabs(z - 0.112f - 0.25f * x) < 0.012f;
    const bool across_instep = std::fabs(z - 0.050f) < 0.011f;
    const bool tie = std::fabs(x + 0.004f + 0.06f * (z - 0.05f)) < 0.0080f && z < 0.150f && z > 0.02f;
    if (heel || across_toes || across_instep || tie)
        return {208 + 26 * value_noise(x * 300, z * 300, 42) - (tie ? 0 : 14), Zone::sandals};
    float g = 222;
    if (z > 0.118f) {  // toes
        const float bounds[] = {-0.017f, -0.001f, 0.013f, 0.026f};
        for (const float b : bounds)
            g -= 84 * spot(x - b + 0.10f * (z - 0.15f), 0.0032f) * smoothstep(0.122f, 0.135f, z);
        const glm::vec2 nails[] = {{-0.027f, 0.176f}, {-0.008f, 0.178f}, {0.007f, 0.172f}, {0.020f, 0.164f}};
        for (const glm::vec2 nail : nails)
            if (spot(glm::vec2(x, z), nail, {0.0075f, 0.0085f}) > 0.25f) g = 248;
    }
    g -= 40 * spot(p.y - 0.0155f, 0.007f);
    g -= 18 * spot(std::fabs(x) - 0.016f, 0.006f) * smoothstep(0.10f, 0.06f, z);
    return {g, Zone::skin};
}

Paint paint_citizen(const Texel &t)
{
    Paint paint;
    switch (t.chart) {
        case Chart::head:
        case Chart::ear:
        case Chart::ear_r:
            paint = paint_head(t);
            break;
        case Chart::arm:
        case Chart::arm_r:
        case Chart::leg:
        case Chart::leg_r:
            paint = paint_limb(t);
            break;
        case Chart::hand_back:
        case Chart::hand_back_r:
        case Chart::hand_palm:
        case Chart::hand_palm_r:
            paint = paint_hand(t);
            break;
        case Chart::foot:
        case Chart::foot_r:
        case Chart::sole:
        case Chart::sole_r:
            paint = paint_foot(t);
            break;
        default:
            paint = paint_cloth(t);
            break;
    }
    // The roots of the fingers lie inside the palm; ambient occlusion would blacken the hands there.
    const bool hand = t.chart >= Chart::hand_back && t.chart <= Chart::hand_palm_r;
    const float open = hand ? std::max(t.ambient_visibility, 0.72f) : t.ambient_visibility;
    const float shade = 0.50f + 0.50f * smoothstep(0.05f, 0.95f, open);
    paint.luminance *= paint.zone == Zone::eyes ? 0.5f + 0.5f * shade : shade;
    return paint;
}

}  // namespace claque::figures
