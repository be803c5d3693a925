#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include "lib/figures/brush.h"
#include "lib/figures/painters.h"
#include "lib/figures/skeleton.h"

namespace claque::figures
{

namespace
{

constexpr float belt_low = 1.012f, belt_high = 1.056f, hem = 0.508f;

// Round the body like an angle, 0 in front, 4 at the back, negative on the right; divisions only.
float around(glm::vec3 p)
{
    const float x = std::fabs(p.x), z = p.z * 1.25f;
    const float quarters = z >= x ? x / z : x >= std::fabs(z) ? 2 - z / x : 4 - x / std::max(-z, 1e-6f);
    return p.x < 0 ? -quarters : quarters;
}

float to_segment(glm::vec3 p, glm::vec3 a, glm::vec3 b)
{
    const glm::vec3 ab = b - a;
    const float t = std::clamp(glm::dot(p - a, ab) / glm::dot(ab, ab), 0.0f, 1.0f);
    return glm::distance(p, a + ab * t);
}

float to_neckline(glm::vec3 p)
{
    static const glm::vec3 line[] = {{0, 1.424f, 0.086f},
                                     {0.050f, 1.440f, 0.070f},
                                     {0.080f, 1.482f, -0.020f},
                                     {0.052f, 1.458f, -0.098f},
                                     {0, 1.462f, -0.104f}};
    p.x = std::fabs(p.x);
    float least = 1;
    for (size_t i = 0; i + 1 < 5; ++i) least = std::min(least, to_segment(p, line[i], line[i + 1]));
    return least;
}

bool on_belt(glm::vec3 p)
{
    const glm::vec2 r(p.x / 0.166f, p.z / 0.121f);
    return p.y > belt_low - 0.001f && p.y < belt_high + 0.002f && r.x * r.x + r.y * r.y < 1;
}

// The two stripes of a citizen's tunic, from the shoulders to the hem.
bool on_stripe(glm::vec3 p, glm::vec3 n)
{
    const float middle = p.y > belt_low ? 0.082f : 0.082f + 0.03f * (belt_low - p.y);
    return std::fabs(std::fabs(p.x) - middle) < 0.0105f && std::fabs(n.z) > 0.25f;
}

Paint belt(glm::vec3 p)
{
    const float height = (p.y - belt_low) / (belt_high - belt_low);
    float g = 214 + 20 * grain(around(p) * 30, p.y * 80, 21) - 50 * soft_step(0.66f, 1.0f, height);
    if (std::fabs(height - 0.12f) < 0.05f || std::fabs(height - 0.62f) < 0.05f) g -= 44;  // stitching
    const glm::vec2 q(p.x, p.y - 1.032f);
    if (p.z > 0.05f) {  // buckle
        const float out = std::max(std::fabs(q.x) / 0.024f, std::fabs(q.y) / 0.017f);
        if (out < 1) g = out > 0.62f ? 255 : 176;
        if (out < 0.8f && std::fabs(q.y) < 0.0035f) g = 240;
    }
    return {g, Zone::belt};
}

// Light and dark of cloth that falls from the shoulders and is gathered at the belt.
float folds(glm::vec3 p, glm::vec3 n)
{
    const float a = around(p);
    float g = 226;
    if (p.y < belt_low) {
        const float down = (belt_low - p.y) / (belt_low - hem);
        const float wander = 0.30f * (grain(a * 2, p.y * 5, 11) - 0.5f);
        const float broad = grain((a + wander) * 4.6f / (0.75f + 0.4f * down), p.y * 1.6f, 12);
        const float fine = grain((a + wander) * 13, p.y * 2.4f, 13);
        g += (56 * (broad - 0.55f)) * soft_step(0, 0.3f, down) + 30 * (fine - 0.5f) * (1 - 0.5f * down);
        g -= 62 * spot(p.y - belt_low, 0.030f);  // shadow of the belt
        g -= 12 * soft_step(0.55f, 1.0f, down);
        return g;
    }
    const float up = p.y - 1.05f;
    const float pleat = grain(a * 12 + 0.6f * grain(a * 4, p.y * 9, 14), p.y * 5, 15);
    g += 52 * (pleat - 0.5f) * soft_step(0.16f, 0.0f, up);                 // gathered above the belt
    g -= 70 * soft_step(-0.2f, -0.85f, n.y) * soft_step(0.05f, 0.0f, up);  // underside of the overhang
    const float sag = std::fabs(p.x);
    const float swing = p.y + (p.z > 0 ? -2.4f : -1.2f) * sag * sag + 0.010f * grain(p.x * 30, p.y * 10, 16);
    const float hang = grain(swing * 17, 3.0f + sag * 2, 17);
    g += 34 * (hang - 0.5f) * soft_step(0.03f, 0.12f, up) * soft_step(0.42f, 0.33f, up);
    g -= 18 * spot(p.x, 0.05f) * spot(p.y - 1.26f, 0.12f) * (p.z > 0 ? 1.0f : 0.4f);
    g += 10 * spot(sag - 0.085f, 0.06f) * spot(p.y - 1.31f, 0.07f);
    return g;
}

float sleeve_folds(glm::vec3 p, float along)
{
    const glm::vec3 from = glm::vec3(std::fabs(p.x), p.y, p.z) - skeleton().joint(Bone::upper_arm);
    const float round = glm::dot(from, arm_dorsal()) * 12 + p.z * 16;
    const float g = 224 + 44 * (grain(round * 2.2f, along * 7, 18) - 0.5f);
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
    const float g = folds(p, t.normal);
    const float neck = to_neckline(p);
    if (neck < 0.017f) return {g - 40 * spot(neck, 0.005f), Zone::border};
    if (p.y < hem + 0.040f) return {g - 36 * spot(p.y - hem - 0.040f, 0.004f), Zone::border};
    if (on_stripe(p, t.normal)) return {g, Zone::border};
    return {g, Zone::tunic};
}

}  // namespace claque::figures
