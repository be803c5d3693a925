// Paints the citizen's tunic and belt.
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include "lib/figures/brush.h"
#include "lib/figures/painters.h"
#include "lib/figures/parts.h"
#include "lib/figures/skeleton.h"

namespace claque::figures
{

namespace
{

constexpr float belt_low = 1.012f, belt_high = 1.056f, hem = 0.508f;

// An angle-like coordinate round the body, 0 in front, 4 at the back, negative on the right. Uses divisions only, so
// that it is the same on every processor.
float around_body(glm::vec3 p)
{
    const float x = std::fabs(p.x), z = p.z * 1.25f;
    const float quarters = z >= x ? x / z : x >= std::fabs(z) ? 2 - z / x : 4 - x / std::max(-z, 1e-6f);
    return p.x < 0 ? -quarters : quarters;
}

float distance_to_segment(glm::vec3 p, glm::vec3 a, glm::vec3 b)
{
    const glm::vec3 ab = b - a;
    const float t = std::clamp(glm::dot(p - a, ab) / glm::dot(ab, ab), 0.0f, 1.0f);
    return glm::distance(p, a + ab * t);
}

float to_neckline(glm::vec3 p)
{
    p.x = std::fabs(p.x);
    float least = 1;
    for (size_t i = 0; i + 1 < neckline.size(); ++i)
        least = std::min(least, distance_to_segment(p, neckline[i], neckline[i + 1]));
    return least;
}

bool on_belt(glm::vec3 p)
{
    const glm::vec2 r(p.x / 0.166f, p.z / 0.121f);
    return p.y > belt_low - 0.001f && p.y < belt_high + 0.002f && r.x * r.x + r.y * r.y < 1;
}

// The two stripes of a citizen's tunic, from the shoulders to the hem along the weave: by the column of the cloth.
bool on_stripe(const Texel &t)
{
    const float column = std::fabs(t.chart == Chart::tunic_front ? t.st.x : t.st.x - 7);
    return column > 0.98f && column < 1.27f;
}

Paint belt(glm::vec3 p)
{
    const float height = (p.y - belt_low) / (belt_high - belt_low);
    float g = 214 + 20 * value_noise(around_body(p) * 30, p.y * 80, 21) - 50 * smoothstep(0.66f, 1.0f, height);
    if (std::fabs(height - 0.12f) < 0.05f || std::fabs(height - 0.62f) < 0.05f) g -= 44;  // stitching
    const glm::vec2 q(p.x, p.y - 1.032f);
    if (p.z > 0.05f) {  // buckle
        const float out = std::max(std::fabs(q.x) / 0.024f, std::fabs(q.y) / 0.017f);
        if (out < 1) g = out > 0.62f ? 255 : 176;
        if (out < 0.8f && std::fabs(q.y) < 0.0035f) g = 240;
    }
    return {g, Zone::belt};
}

// The luminance of a fold from noise in [0, 1): a bright ridge beside a dark furrow.
float furrow(float noise)
{
    const float x = noise * 2 - 1;
    return x * (1.25f - 0.5f * x * x) - 0.45f * spot(x + 0.30f, 0.22f);
}

// The luminance of cloth that falls from the shoulders and is gathered at the belt.
float cloth_folds(glm::vec3 p, glm::vec3 n)
{
    const float a = around_body(p);
    float g = 222;
    if (p.y < belt_low) {
        const float down = (belt_low - p.y) / (belt_low - hem);
        const float wander = 0.22f * (value_noise(a * 2, p.y * 5, 11) - 0.5f);
        const float broad = value_noise((a + wander) * 5.2f / (0.8f + 0.3f * down), p.y * 1.3f, 12);
        const float fine = value_noise((a + wander) * 15, p.y * 2.2f, 13);
        g += 34 * furrow(broad) * smoothstep(-0.05f, 0.35f, down) + 18 * furrow(fine) * (1 - 0.75f * down);
        g -= 66 * spot(p.y - belt_low, 0.026f);  // shadow of the belt
        return g;
    }
    const float up = p.y - 1.05f;
    const float pleat = value_noise(a * 11 + 0.5f * value_noise(a * 4, p.y * 9, 14), p.y * 4, 15);
    g += 30 * furrow(pleat) * smoothstep(0.19f, 0.01f, up);                  // gathered above the belt
    g -= 74 * smoothstep(-0.2f, -0.85f, n.y) * smoothstep(0.05f, 0.0f, up);  // underside of the overhang
    g -= 26 * spot(up, 0.022f);
    const float sag = std::fabs(p.x);
    const float swing = p.y + (p.z > 0 ? -3.2f : -1.6f) * sag * sag + 0.016f * value_noise(p.x * 26, p.y * 9, 16);
    const float hang =
        0.55f * value_noise(swing * 16, 3.0f + sag * 3, 17) + 0.45f * value_noise(swing * 34, 5.0f + sag * 5, 19);
    g += 32 * furrow(hang) * smoothstep(0.05f, 0.16f, up) * smoothstep(0.42f, 0.33f, up);
    g -= 16 * spot(p.x, 0.05f) * spot(p.y - 1.26f, 0.12f) * (p.z > 0 ? 1.0f : 0.4f);
    g += 10 * spot(sag - 0.085f, 0.06f) * spot(p.y - 1.31f, 0.07f);
    return g;
}

float sleeve_folds(glm::vec3 p, float along)
{
    const glm::vec3 from = glm::vec3(std::fabs(p.x), p.y, p.z) - skeleton().joint(Bone::upper_arm);
    const float round = glm::dot(from, arm_dorsal()) * 12 + p.z * 16;
    const float g = 222 + 26 * furrow(value_noise(round * 2.4f + along * 2, along * 3, 18));
    return g - 26 * spot(glm::dot(from, arm_dorsal()) + 0.08f, 0.04f);
}

}  // namespace

Paint paint_cloth(const Texel &t)
{
    const glm::vec3 p = t.position;
    if (t.chart == Chart::tunic_inside || t.chart == Chart::sleeve_inside || t.chart == Chart::sleeve_inside_r)
        return {118, Zone::tunic};
    if (t.chart == Chart::sleeve || t.chart == Chart::sleeve_r) {
        const glm::vec3 from = glm::vec3(std::fabs(p.x), p.y, p.z) - skeleton().joint(Bone::upper_arm);
        const float along = glm::dot(from, arm_direction());
        const float g = sleeve_folds(p, along);
        if (along > 0.208f) return {g - 30 * spot(along - 0.208f, 0.003f), Zone::border};
        return {g, Zone::tunic};
    }
    if (on_belt(p)) return belt(p);
    const float g = cloth_folds(p, t.normal);
    const float neck = to_neckline(p);
    if (neck < 0.017f) return {g - 40 * spot(neck, 0.005f), Zone::border};
    if (p.y < hem + 0.040f) return {g - 36 * spot(p.y - hem - 0.040f, 0.004f), Zone::border};
    if (on_stripe(t)) return {g, Zone::border};
    return {g, Zone::tunic};
}

}  // namespace claque::figures
