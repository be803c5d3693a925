// Paints the owl: plumage, head, eyes and letter.
#include <cmath>

#include "lib/figures/brush.h"
#include "lib/figures/flyer/owl/owl.h"
#include "lib/math/trig.h"

namespace claque::figures::flyer::owl
{

namespace
{

// Feathers like tiles: rounded ends that overlap the next row, and a dark quill.
float tiles(float across, float up)
{
    const float row = std::floor(up), shifted = across + 0.5f * (row - 2 * std::floor(row / 2));
    const float x = 2 * (shifted - std::floor(shifted)) - 1, y = up - row;
    const float edge = 0.34f * (1 - x * x);  // the outline of this row's ends
    const float hangs = y + edge - 0.34f;
    const float shade = value_noise(std::floor(shifted) * 2.7f + 30, row * 3.1f + 70, 31);
    return 222 + 26 * (shade - 0.5f) - 62 * spot(hangs, 0.16f) - 22 * spot(x, 0.16f) * smoothstep(0.2f, 0.8f, y);
}

// Breast in front, plumage behind; the border is ragged.
Paint body(const Texel &t, float rows)
{
    const float front = 1 - 2 * std::fabs(t.st.x - 0.5f);  // 1 ahead, 0 behind
    const bool breast = front > 0.50f + 0.08f * (value_noise(t.st.y * 18, front * 3, 32) - 0.5f);
    float g = tiles(t.st.x * 26, t.st.y * rows);
    if (!breast) return {g - 14, Zone::outer};
    // Arrow marks on the breast.
    const float x = t.st.x * 13 - std::floor(t.st.x * 13) - 0.5f, y = t.st.y * rows / 2;
    const float mark = spot(y - std::floor(y) - 0.3f - std::fabs(x), 0.20f);
    return {g + 12 - 60 * mark * spot(x, 0.42f), Zone::tunic};
}

struct Dish {
    float r;  // from the eye, 1 at the rim
    bool inside;
};
Dish dish_at(glm::vec2 q)
{
    const glm::vec2 d = (q - glm::vec2(0.088f, 0.012f)) / glm::vec2(0.122f, 0.130f);
    const float r = std::sqrt(d.x * d.x + d.y * d.y);
    return {r, r < 1};
}

Paint head(const Texel &t)
{
    const glm::vec3 p = t.position - head_centre;
    const glm::vec2 q(std::fabs(p.x), p.y);
    if (p.z > 0.02f) {
        const Dish dish = dish_at(q);
        if (dish.r > 0.93f && dish.r < 1.06f) return {96, Zone::outer};
        if (dish.inside) {
            const glm::vec2 d = q - glm::vec2(0.088f, 0.012f);
            const float ray = value_noise((d.x * 60 + 40) / (0.25f + dish.r), (d.y * 60 + 40) / (0.25f + dish.r), 33);
            return {236 - 34 * ray - 30 * spot(dish.r - 0.50f, 0.14f), Zone::hair};
        }
    }
    return {tiles(t.st.x * 5.2f, t.st.y * 34 + 20) - 10, Zone::outer};
}

Paint far_head(const Texel &t)
{
    const glm::vec3 p = t.position - head_centre;
    const glm::vec2 q(std::fabs(p.x), t.st.y);
    if (p.z > 0.02f) {
        const glm::vec2 d = q - glm::vec2(0.095f, 0.020f);
        const float r = std::sqrt(d.x * d.x + d.y * d.y);
        if (r < 0.054f) return {r < 0.026f ? 26.0f : 226.0f, Zone::eyes};
        if (q.x < 0.030f && q.y < 0.04f && q.y > -0.07f) return {180, Zone::skin};
        const Dish dish = dish_at(q);
        if (dish.inside) return {dish.r > 0.90f ? 150.0f : 224.0f, Zone::hair};
    }
    return {200, Zone::outer};
}

Paint eye(const Texel &t)
{
    const float r = glm::length(t.st);
    if (glm::length(t.st - glm::vec2(0.20f, 0.22f)) < 0.09f) return {255, Zone::eyes};
    if (r < 0.36f) return {20, Zone::eyes};
    const float spoke = value_noise(t.st.x * 9 / (r + 0.05f) + 60, t.st.y * 9 / (r + 0.05f) + 60, 34);
    return {r < 0.86f ? 236 - 40 * spoke - 60 * spot(r - 0.86f, 0.16f) - 30 * spot(r - 0.36f, 0.08f) : 70, Zone::eyes};
}

Paint letter(const Texel &t)
{
    if (std::fabs(t.st.y - 0.5f) < 0.06f) return {210, Zone::border};
    return {t.st.y < 0.09f || t.st.y > 0.91f ? 170.0f : 244.0f, Zone::hair};
}

}  // namespace

Paint paint(const Texel &t)
{
    if (t.chart == head_chart) return head(t);
    if (t.chart == far_head_chart) return far_head(t);
    if (t.chart == eye_chart) return eye(t);
    if (t.chart == lid_chart)
        return t.st.y < 0.58f ? Paint{90, Zone::outer} : Paint{tiles(t.st.x * 4, t.st.y * 5), Zone::hair};
    if (t.chart == beak_chart) return {196 + 50 * t.st.y - 30 * spot(t.st.x - 0.5f, 0.15f), Zone::skin};
    if (t.chart == tuft_chart) return {190 + 46 * math::sin(t.st.x * 22) * (1 - t.st.y) - 60 * t.st.y, Zone::outer};
    if (t.chart == ruff_chart) return {tiles(t.st.x * 24, t.st.y * 3), Zone::hair};
    if (t.chart == chest_chart) return body(t, 7);
    if (t.chart == belly_chart) return body(t, 11);
    if (t.chart == collar_chart)
        return {214 - 60 * spot(t.st.y - 0.92f, 0.1f) + 20 * math::sin(t.st.x * 120), Zone::jewellery};
    if (t.chart == foot_chart) return {tiles(t.st.x * 9, t.st.y * 5), Zone::tunic};
    if (t.chart == talon_chart) return {200 - 120 * smoothstep(0.55f, 0.75f, t.st.y), Zone::skin};
    if (t.chart == letter_chart) return letter(t);
    if (t.chart == far_body_chart) return {200, t.position.z > 0.05f ? Zone::tunic : Zone::outer};
    if (t.chart == tail_chart) {
        const float c = -t.st.x, k = t.st.y * 5, x = 2 * (k - std::floor(k)) - 1;
        const float bar = math::sin(c * 26 - 3 * x * x);
        return {
            214 - 50 * smoothstep(0.2f, 0.8f, bar) - 46 * smoothstep(0.84f, 1.0f, std::fabs(x)) - 30 * spot(x, 0.1f),
            Zone::wings};
    }
    return paint_wing(t, {4, Zone::outer, Zone::wings});
}

}  // namespace claque::figures::flyer::owl
