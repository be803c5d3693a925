// The stola: fine pleats from the girdle, broad ones below, a border at hem, neck and sleeves.
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include "lib/figures/brush.h"
#include "lib/figures/patrician/paint.h"
#include "lib/figures/patrician/patrician.h"
#include "lib/figures/skeleton.h"

namespace claque::figures::patrician
{

float crease(float noise)
{
    const float x = noise * 2 - 1;
    return x * (1.25f - 0.5f * x * x) - 0.45f * spot(x + 0.30f, 0.22f);
}

float around_body(glm::vec3 p)
{
    const float x = std::fabs(p.x), z = p.z * 1.25f;
    const float quarters = z >= x              ? x / std::max(z, 1e-6f)
                           : x >= std::fabs(z) ? 2 - z / x
                                               : 4 - x / std::max(-z, 1e-6f);
    return p.x < 0 ? -quarters : quarters;
}

float wrapped_noise(float around, int count, float y, uint64_t layer)
{
    const float n = static_cast<float>(count), x = (around + 4) / 8 * n;
    const float join = smoothstep(n - 1, n, x);
    return value_noise(x, y, layer) * (1 - join) + value_noise(x - n, y, layer) * join;
}

namespace
{

constexpr float girdle = 1.196f, hem_border = 0.105f;

float to_segment(glm::vec3 p, glm::vec3 a, glm::vec3 b)
{
    const glm::vec3 ab = b - a;
    const float t = std::clamp(glm::dot(p - a, ab) / glm::dot(ab, ab), 0.0f, 1.0f);
    return glm::distance(p, a + ab * t);
}

float to_neckline(glm::vec3 p)
{
    p.x = std::fabs(p.x);
    float least = 1;
    for (size_t i = 0; i + 1 < bodice_neckline.size(); ++i)
        least = std::min(least, to_segment(p, bodice_neckline[i], bodice_neckline[i + 1]));
    return least;
}

float skirt(glm::vec3 p)
{
    const float a = around_body(p);
    const float wander = 0.25f * (wrapped_noise(a, 14, p.y * 4, 111) - 0.5f);
    const float broad = wrapped_noise(a + wander, 34, p.y * 1.1f, 112),
                fine = wrapped_noise(a + wander, 96, p.y * 1.6f, 113);
    float g = 224 + 42 * crease(broad) + 18 * crease(fine);
    g -= 30 * spot(p.y - 0.045f, 0.03f);
    if (p.z > 0.05f) g -= 20 * spot(p.x, 0.045f) * smoothstep(0.10f, 0.25f, p.y);  // between the legs
    return g;
}

float bodice(glm::vec3 p)
{
    const float a = around_body(p), up = p.y - girdle;
    const float pleat = wrapped_noise(a + 0.05f * wrapped_noise(a, 32, p.y * 9, 114), 96, p.y * 5, 115);
    float g = 226 + 30 * crease(pleat) * smoothstep(0.12f, 0.0f, std::fabs(up));
    if (p.z > 0) {  // soft round of the breasts, and the valley
        const glm::vec2 q(std::fabs(p.x), p.y);
        g += 16 * spot(q, {0.072f, 1.292f}, {0.050f, 0.045f});
        g -= 26 * spot(q, {0.074f, 1.235f}, {0.060f, 0.026f});
        g -= 22 * spot(q, {0.0f, 1.285f}, {0.026f, 0.075f});
    }
    const float swing = p.y - 2.2f * p.x * p.x + 0.016f * value_noise(p.x * 26, p.y * 9, 116);
    g += 18 * crease(value_noise(swing * 22, 3.0f + std::fabs(p.x) * 4, 117)) * smoothstep(0.10f, 0.16f, up);
    g -= 46 * spot(std::fabs(up) - 0.018f, 0.016f);  // shadow beside the girdle
    return g;
}

Paint band_of_girdle(glm::vec3 p)
{
    const float a = around_body(p), up = (p.y - girdle) / 0.015f;
    float g = 226 - 60 * up * up;
    if (std::fabs(p.x) < 0.022f && p.z > 0.05f) {  // clasp
        const glm::vec2 d(p.x / 0.020f, up);
        g = d.x * d.x + d.y * d.y < 0.45f ? 255 : 150;
        return {g, Zone::jewellery};
    }
    g -= 36 * spot(std::fabs(std::fmod(std::fabs(a) * 12 + up * 0.5f, 1.0f) - 0.5f), 0.2f);  // twisted cord
    return {g, Zone::belt};
}

Paint sleeve(const Texel &t)
{
    const glm::vec3 from =
        mirrored(t.position, t.position.x >= 0 ? Side::left : Side::right) - skeleton().joint(Bone::upper_arm);
    const float along = glm::dot(from, arm_direction()), up = glm::dot(from, arm_dorsal());
    const float round = up * 12 + from.z * 16;
    float g = 224 + 24 * crease(value_noise(round * 2.4f + along * 2, along * 3, 118));
    // Buttoned along the top of the arm, as the tunics under stolas were.
    const float button = std::fmod(along, 0.042f) - 0.021f;
    const float d = std::sqrt(button * button + from.z * from.z);
    if (up > 0.02f && along > 0.03f && along < 0.23f) {
        if (d < 0.0055f) return {250 - 90 * smoothstep(0.003f, 0.0055f, d), Zone::jewellery};
        g -= 40 * spot(from.z, 0.004f) + 24 * spot(d - 0.008f, 0.006f);
    }
    if (along > 0.236f) return {g - 30 * spot(along - 0.236f, 0.003f), Zone::border};
    return {g - 20 * spot(up + 0.06f, 0.03f), Zone::tunic};
}

}  // namespace

Paint paint_stola(const Texel &t)
{
    const glm::vec3 p = t.position;
    if (t.chart == gown_inside || t.chart == Chart::sleeve_inside || t.chart == Chart::sleeve_inside_r)
        return {110, Zone::tunic};
    if (t.chart == Chart::sleeve || t.chart == Chart::sleeve_r) return sleeve(t);
    if (t.chart == gown_front || t.chart == gown_back) {
        const float g = skirt(p);
        if (p.y < hem_border) return {g + 10 - 50 * spot(p.y - hem_border, 0.006f), Zone::border};
        if (std::fabs(p.y - hem_border - 0.022f) < 0.006f) return {g + 10, Zone::border};
        return {g, Zone::tunic};
    }
    if (std::fabs(p.y - girdle) < 0.0155f) return band_of_girdle(p);
    const float neck = to_neckline(p);
    const float g = bodice(p);
    if (neck < 0.014f) return {g - 40 * spot(neck, 0.004f), Zone::border};
    return {g - 20 * spot(neck - 0.016f, 0.006f), Zone::tunic};
}

}  // namespace claque::figures::patrician
