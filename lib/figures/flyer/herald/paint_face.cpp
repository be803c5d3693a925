// Paints the herald's head: face, jaw, eyes, lids and hair.
#include <cmath>

#include "lib/figures/brush.h"
#include "lib/figures/flyer/herald/paint.h"
#include "lib/math/trig.h"

namespace claque::figures::flyer::herald
{

namespace
{

// Locks that fall from the crown in waves.
Paint hair(glm::vec2 st, float over)
{
    const float angle = angle_of(std::fabs(st.x)) * (st.x < 0 ? -1.0f : 1.0f);
    const float fall = st.y * 60 + 0.8f * value_noise(angle * 4 + 20, st.y * 30, 2);
    const float bend = 0.5f * math::sin(fall * 1.1f + 2 * value_noise(angle * 1.5f + 9, 3, 5));
    const float u = angle * 7.5f + bend;
    const float across = u - std::floor(u);
    const float lock = 1 - 4 * (across - 0.5f) * (across - 0.5f);
    const float strand = value_noise(u * 5 + 40, fall * 0.5f, 4);
    const float edge = smoothstep(0, 0.012f, over);
    return {108 + 66 * lock + 46 * strand - 34 * (1 - edge), Zone::hair};
}

bool is_lip(glm::vec2 q, float shift)
{
    const float u = q.x / 0.0235f;
    if (u > 1) return false;
    const float line = -0.0735f + 0.0030f * u * u + shift;
    const float top = line + 0.0085f * (1 - u * u) - 0.0016f * spot(q.x, 0.006f);
    const float bottom = line - 0.0095f * std::sqrt(1 - u * u);
    return q.y < top && q.y > bottom;
}

float skin_shade(glm::vec2 q)
{
    float g = 226;
    g += 14 * spot(q, {0, -0.010f}, {0.008f, 0.045f});        // ridge of the nose
    g += 12 * spot(q, {0.050f, -0.022f}, {0.024f, 0.018f});   // cheekbone
    g += 8 * spot(q, {0, 0.068f}, {0.050f, 0.022f});          // forehead
    g -= 30 * spot(q, {0.016f, 0.020f}, {0.010f, 0.020f});    // beside the root of the nose
    g -= 24 * spot(q, {0.039f, 0.040f}, {0.030f, 0.011f});    // under the brow
    g -= 22 * spot(q, {0.019f, -0.036f}, {0.007f, 0.012f});   // wing of the nose
    g -= 44 * spot(q, {0.009f, -0.0475f}, {0.008f, 0.005f});  // nostril
    g -= 16 * spot(q, {0, -0.058f}, {0.005f, 0.008f});        // groove of the upper lip
    g -= 20 * spot(q, {0.028f, -0.072f}, {0.007f, 0.008f});   // corner of the mouth
    g -= 22 * spot(q, {0, -0.0900f}, {0.020f, 0.006f});       // below the lower lip
    return g;
}

// A blush, as darker skin.
float blush(glm::vec2 q) { return 12 * spot(q, {0.056f, -0.034f}, {0.022f, 0.018f}); }

}  // namespace

Paint paint_whole_head(const Texel &t)
{
    const glm::vec3 p = t.position - head_centre;
    const float angle = angle_of(std::fabs(t.st.x));
    const float jag = 0.008f * (value_noise(angle * 14 * (t.st.x < 0 ? -1.0f : 1.0f) + 50, 2, 1) - 0.5f);
    const float over = t.st.y - hairline(angle) - jag;
    if (over > 0) return hair(t.st, over);
    const glm::vec2 q(std::fabs(p.x), p.y);
    if (p.z < 0.01f || q.y < -0.11f) {
        // The ear is painted at its place.
        const glm::vec2 e(p.z, p.y);
        const float ear = spot(e, {-0.012f, -0.012f}, {0.024f, 0.036f});
        return {222 - 50 * spot(e, {-0.008f, -0.008f}, {0.010f, 0.016f}) - 20 * ear - 24 * spot(over, 0.008f),
                Zone::skin};
    }
    const bool in_mouth = q.y < -0.0745f && q.y > -0.12f && angle < 0.55f;
    if (in_mouth) return {60, Zone::lips};
    if (is_lip(q, 0)) return {q.y < -0.072f ? 150.0f : 196.0f, Zone::lips};
    float g = skin_shade(q) - blush(q) - 24 * spot(over, 0.008f);
    // Inside the socket, where the ball touches it.
    g -= 60 * spot(glm::vec2(q.x, q.y), {eye_left.x, 0.018f}, {0.027f, 0.021f});
    return {g, Zone::skin};
}

Paint paint_jaw(const Texel &t)
{
    const glm::vec3 p = t.position - head_centre;
    const glm::vec2 q(std::fabs(p.x), p.y);
    if (is_lip(q, 0)) return {212 + 20 * spot(q, {0.006f, -0.079f}, {0.012f, 0.004f}), Zone::lips};
    float g = skin_shade(q) - blush(q);
    if (q.y > -0.0765f) g -= 26;  // the seam to the cheek
    g -= 22 * smoothstep(-0.118f, -0.140f, q.y);
    return {g, Zone::skin};
}

// The whole face in one picture, with enlarged features, for heads without sculpted features.
Paint paint_far_head(const Texel &t)
{
    const float angle = angle_of(std::fabs(t.st.x));
    const float over = t.st.y - hairline(angle);
    if (over > 0) return hair(t.st, over);
    const glm::vec3 p = t.position - head_centre;
    const glm::vec2 q(std::fabs(p.x), t.st.y);
    if (p.z > 0) {
        const glm::vec2 e = (q - glm::vec2(eye_left.x, 0.019f)) / glm::vec2(0.019f, 0.0115f);
        const float r = glm::length(e);
        if (r < 1) return {r < 0.62f ? 62.0f : 226.0f, Zone::eyes};
        if (std::fabs(q.y - 0.053f) < 0.006f && q.x > 0.012f && q.x < 0.062f) return {128, Zone::hair};
        if (is_lip(q, 0)) return {std::fabs(q.y + 0.0735f) < 0.002f ? 110.0f : 190.0f, Zone::lips};
        return {skin_shade(q) - blush(q) - 40 * spot(q, {eye_left.x, 0.034f}, {0.026f, 0.008f}), Zone::skin};
    }
    return {214, Zone::skin};
}

Paint paint_eye(const Texel &t)
{
    const float r = glm::length(t.st);
    float grey = 240 - 50 * smoothstep(0.4f, 1.0f, r);
    if (r < 0.46f) grey = r < 0.20f ? 18 : r < 0.40f ? 84 + 60 * smoothstep(0.1f, -0.4f, t.st.y) : 48;
    if (glm::length(t.st - glm::vec2(0.15f, 0.17f)) < 0.085f) grey = 255;
    return {grey, Zone::eyes};
}

Paint paint_lid(const Texel &t)
{
    if (t.st.y < 0.47f) return {84, Zone::hair};  // lashes
    return {206 - 20 * smoothstep(0.8f, 1.3f, t.st.y) + 10 * spot(t.st.y - 0.65f, 0.2f), Zone::skin};
}

}  // namespace claque::figures::flyer::herald
