#include "lib/figures/flyer/herald/paint.h"

#include <cmath>

#include "lib/figures/brush.h"
#include "lib/figures/flyer/wing.h"
#include "lib/math/trig.h"

namespace claque::figures::flyer::herald
{

namespace
{

constexpr float turn = 6.28318531f;

Paint paint_chest(const Texel &t)
{
    const float u = t.st.x * turn, y = t.position.y;
    // Folds gather towards the belt and fall from the shoulders in swags.
    const float fall = value_noise(t.st.x * 44 + 0.8f * math::sin(y * 14), y * 6, 11);
    const float swag = math::sin(y * 46 + 2.2f * math::cos(u * 2)) * smoothstep(0.16f, 0.30f, y);
    float g = 224 + 36 * (fall - 0.5f) * smoothstep(0.42f, 0.16f, y) + 5 * swag;
    if (y > 0.112f && y < 0.142f && t.st.y < 0.2f) {
        const float buckle = spot(glm::vec2(t.position.x, y), {0, 0.127f}, {0.030f, 0.030f});
        if (buckle > 0.25f && t.position.z > 0) return {228 - 90 * spot(buckle - 0.5f, 0.16f), Zone::jewellery};
        return {188 - 60 * spot(std::fabs(y - 0.127f) - 0.013f, 0.004f), Zone::belt};
    }
    // Under the arms, and below the belt where the cloth blouses over the hips.
    g -= 34 * spot(glm::vec2(std::fabs(t.position.x), y), {0.16f, 0.300f}, {0.075f, 0.110f});
    g -= 22 * spot(y - 0.108f, 0.020f) + 50 * smoothstep(0.05f, 0.0f, t.st.y);
    return {g, Zone::tunic};
}

Paint paint_skirt(const Texel &t)
{
    const float pleat = math::cos(turn * t.st.x * 6);
    float g = 214 + 22 * pleat * (1 - t.st.y) + 18 * (value_noise(t.st.x * 48, t.st.y * 3, 12) - 0.5f);
    g -= 60 * smoothstep(0.72f, 0.95f, t.st.y);  // below the blouse
    if (t.st.y < 0.13f && t.st.y > 0.035f) {
        // A running pattern: squares on a band.
        const float k = t.st.x * 32, in = k - std::floor(k);
        const bool square = in > 0.3f && in < 0.7f && t.st.y > 0.06f && t.st.y < 0.105f;
        return {g - (square ? -20.0f : 20.0f), Zone::border};
    }
    return {g, Zone::tunic};
}

Paint collar(const Texel &t)
{
    const float bead = math::cos(turn * t.st.x * 24) * spot(t.st.y - 0.22f, 0.2f);
    return {204 + 26 * bead - 50 * spot(t.st.y - 0.45f, 0.05f) - 40 * spot(t.st.y - 0.02f, 0.05f), Zone::jewellery};
}

Paint sleeve(const Texel &t)
{
    // t.st.y is 0 at the top of the shoulder and decreases along the arm; the hem is at about -0.26.
    const float g = 220 + 16 * (value_noise(t.st.x * 18, t.st.y * 9, 13) - 0.5f);
    if (t.st.y < -0.270f) return {100, Zone::tunic};
    if (t.st.y < -0.222f) return {g - 14, Zone::border};
    return {g, Zone::tunic};
}

Paint arm(const Texel &t)
{
    float g = 224 - 10 * value_noise(t.st.x * 4, t.st.y * 12, 14);
    if (t.st.y < -0.315f && t.st.y > -0.345f) return {214 - 40 * spot(t.st.y + 0.330f, 0.006f), Zone::jewellery};
    if (t.st.y < -0.40f) {
        // Fingers folded round the object that they hold.
        const float finger = t.st.x * 11, gap = std::fabs(finger - std::floor(finger) - 0.5f);
        g -= 46 * spot(gap - 0.5f, 0.16f);
    }
    return {g, Zone::skin};
}

Paint leg(const Texel &t)
{
    // From 0 at the hip; the ankle is at about -0.60, the toes at -0.78.
    const float y = t.st.y, front = 1 - 2 * std::fabs(t.st.x - 0.5f);
    float g = 222 + 8 * front - 12 * spot(y + 0.37f, 0.03f) * front;
    if (y < -0.635f) {
        const float strap = std::fabs((y + 0.70f) * 1.0f + 0.05f * (front - 0.5f));
        if (y < -0.755f) return {g - 8, Zone::skin};
        if (front < 0.34f && y < -0.655f) return {150, Zone::sandals};
        return strap < 0.014f || y > -0.650f ? Paint{196, Zone::sandals} : Paint{g, Zone::skin};
    }
    // Laces cross over the calf.
    if (y < -0.46f) {
        const float wind = (y + 0.46f) * 16, up = std::fabs(t.st.x * 2 - 1);
        const float a = wind + up * 2, b = wind - up * 2;
        if (std::fabs(a - std::floor(a) - 0.5f) < 0.12f || std::fabs(b - std::floor(b) - 0.5f) < 0.12f)
            return {190, Zone::sandals};
    }
    return {g, Zone::skin};
}

Paint trumpet(const Texel &t)
{
    const float y = t.st.y;  // from 0 in the mouth of the bell
    if (y > -0.080f) return {92 - 40 * smoothstep(-0.08f, 0, y), Zone::jewellery};
    const float ring = spot(y + 0.40f, 0.012f) + spot(y + 0.78f, 0.012f);
    return {196 + 44 * math::sin(turn * t.st.x + 0.8f) - 70 * ring, Zone::jewellery};
}

Paint far_limb(const Texel &t)
{
    const float y = t.position.y;
    if (y > 0.66f) return {150, Zone::hair};
    if (y > 0.47f) return {210, Zone::skin};
    return y > -0.32f ? Paint{206, Zone::tunic} : Paint{206, Zone::skin};
}

Paint plain(const Texel &t)
{
    if (t.chart == mouth_chart) return {t.st.y < 0.25f ? 200.0f : 70.0f, Zone::lips};
    if (t.chart == brow_chart) return {120 + 70 * value_noise(t.st.x * 14, t.st.y * 2, 7), Zone::hair};
    if (t.chart == neck_chart) return {216 - 10 * spot(std::fabs(t.st.x - 0.5f) - 0.1f, 0.05f), Zone::skin};
    if (t.chart == lining_chart) return {120 - 40 * t.st.y, Zone::tunic};
    if (t.chart == scroll_chart) {
        if (std::fabs(t.st.y + 0.174f) < 0.014f) return {200, Zone::border};  // the ribbon
        const float end = std::min(std::fabs(t.st.y), std::fabs(t.st.y + 0.344f));
        return {end < 0.024f ? 150 + 60 * math::cos(end * 900) : 240.0f, Zone::eyes};
    }
    if (t.chart == talaria_chart) return {230 - 60 * spot(t.st.x * 4 - std::floor(t.st.x * 4), 0.3f), Zone::wings};
    return {176 + 60 * spot(t.st.y - 0.5f, 0.5f) - 50 * spot(t.st.y - 0.5f, 0.08f), Zone::belt};  // leaves
}

Paint colour(const Texel &t)
{
    if (t.chart == head_chart) return paint_whole_head(t);
    if (t.chart == far_head_chart) return paint_far_head(t);
    if (t.chart == jaw_chart) return paint_jaw(t);
    if (t.chart == eye_chart) return paint_eye(t);
    if (t.chart == lid_chart) return paint_lid(t);
    if (t.chart == wing_back_chart || t.chart == wing_front_chart) return paint_wing(t, Plumage());
    if (t.chart == chest_chart) return paint_chest(t);
    if (t.chart == collar_chart) return collar(t);
    if (t.chart == skirt_chart) return paint_skirt(t);
    if (t.chart == sleeve_chart) return sleeve(t);
    if (t.chart == arm_chart) return arm(t);
    if (t.chart == leg_chart) return leg(t);
    if (t.chart == trumpet_chart) return trumpet(t);
    if (t.chart == far_limb_chart) return far_limb(t);
    return plain(t);
}

}  // namespace

Paint paint(const Texel &t)
{
    Paint p = colour(t);
    // Cloth and wings have painted shades; parts that move near them leave no permanent shadow.
    const bool shaded = t.chart == head_chart || t.chart == jaw_chart || t.chart == neck_chart ||
                        t.chart == collar_chart || t.chart == lining_chart || t.chart == leg_chart;
    if (shaded) p.luminance *= 0.70f + 0.30f * smoothstep(0.10f, 0.80f, t.ambient_visibility);
    return p;
}

}  // namespace claque::figures::flyer::herald
