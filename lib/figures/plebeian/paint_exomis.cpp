// Rough wool girded with a rope, and the bare skin beside it: the right breast, shoulder and shoulder blade.
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include "lib/figures/brush.h"
#include "lib/figures/plebeian/plebeian.h"
#include "lib/figures/skeleton.h"

namespace claque::figures::plebeian
{

namespace
{

constexpr float rope_low = 1.016f, rope_high = 1.052f, hem = 0.590f;

// An angle-like coordinate round the body, 0 in front, 4 at the back, negative on the right. Uses divisions only, so
// that it is the same on every processor.
float around(glm::vec3 p)
{
    const float x = std::fabs(p.x), z = p.z * 1.25f;
    const float quarters = z >= x ? x / z : x >= std::fabs(z) ? 2 - z / x : 4 - x / std::max(-z, 1e-6f);
    return p.x < 0 ? -quarters : quarters;
}

// Metres from the slanting edge of the cloth, which runs from the left shoulder to under the right arm; positive
// inside.
float inside_cloth(const Texel &t)
{
    static const glm::vec2 front[] = {{-0.170f, 1.262f}, {-0.110f, 1.268f}, {-0.050f, 1.300f},
                                      {0.010f, 1.356f},  {0.060f, 1.424f},  {0.090f, 1.490f}};
    static const glm::vec2 back[] = {
        {-0.170f, 1.262f}, {-0.090f, 1.280f}, {-0.010f, 1.350f}, {0.060f, 1.440f}, {0.090f, 1.490f}};
    const glm::vec3 p = t.position;
    if (t.chart == Chart::sleeve) return 1;
    if (t.chart == Chart::sleeve_r) return -1;
    const float wave = 0.006f * (value_noise(p.x * 24 + 5, p.z > 0 ? 1.0f : 7.0f, 221) - 0.5f);
    return ((p.z > 0 ? profile(front, p.x) : profile(back, p.x)) + wave - p.y) * 0.75f;
}

// Chart heights are those of the figure up to the fold over the rope; from there they continue along the cloth.
bool on_rope(const Texel &t) { return t.st.y > rope_low && t.st.y < rope_high + 0.004f; }

// Two strands twisted round each other.
Paint rope(glm::vec3 p)
{
    const float height = (p.y - rope_low) / (rope_high - rope_low);
    const float turn = height < 0.5f ? 2 * height : 2 * height - 1;
    const float twist = around(p) * 11 + turn * 1.1f;
    const float strand = twist - std::floor(twist);
    float g = 236 - 74 * spot(strand, 0.20f) - 74 * spot(strand - 1, 0.20f) +
              16 * value_noise(around(p) * 60, p.y * 300, 222);
    g -= 90 * spot(height - 0.5f, 0.12f) + 44 * spot(height, 0.16f) + 44 * spot(height - 1, 0.16f);
    return {g, Zone::belt};
}

// The luminance of a fold from noise in [0, 1): a bright ridge beside a dark furrow.
float furrow(float noise)
{
    const float x = noise * 2 - 1;
    return x * (1.25f - 0.5f * x * x) - 0.45f * spot(x + 0.30f, 0.22f);
}

float skirt(glm::vec3 p)
{
    const float a = around(p), down = (rope_low - p.y) / (rope_low - hem);
    const float wander = 0.25f * (value_noise(a * 2, p.y * 6, 223) - 0.5f);
    const float broad = value_noise((a + wander) * 4.6f / (0.8f + 0.3f * down), p.y * 1.5f, 224);
    const float fine = value_noise((a + wander) * 13, p.y * 3, 225);
    return 220 + 36 * furrow(broad) * smoothstep(-0.05f, 0.35f, down) + 22 * furrow(fine) * (1 - 0.7f * down) -
           64 * spot(p.y - rope_low, 0.026f);
}

// Above the rope the cloth is gathered, then pulled towards the knot on the left shoulder.
float bodice(glm::vec3 p, glm::vec3 n)
{
    const float a = around(p), up = p.y - 1.045f;
    const float pleat = value_noise(a * 10 + 0.6f * value_noise(a * 4, p.y * 9, 226), p.y * 4, 227);
    float g = 220 + 32 * furrow(pleat) * smoothstep(0.18f, 0.01f, up);
    g -= 60 * smoothstep(-0.2f, -0.85f, n.y) * smoothstep(0.05f, 0.0f, up) + 8 * spot(up, 0.018f);
    const glm::vec2 from(0.115f - p.x, 1.475f - p.y);
    const float ray = from.x / (from.y + 0.10f), far = std::sqrt(from.x * from.x + from.y * from.y);
    const float pull =
        value_noise(ray * 9 + 0.7f * value_noise(ray * 5, far * 7, 228), far * 3 + (p.z > 0 ? 0.0f : 9.0f), 229);
    return g + 34 * furrow(pull) * smoothstep(0.06f, 0.18f, up);
}

Paint sleeve(glm::vec3 p)
{
    const glm::vec3 from = p - skeleton().joint(Bone::upper_arm);
    const float along = glm::dot(from, arm_direction());
    const float round = glm::dot(from, arm_dorsal()) * 12 + p.z * 16;
    const float g = 220 + 28 * furrow(value_noise(round * 2.2f + along * 2, along * 4, 230));
    return {g, along > 0.186f ? Zone::border : Zone::tunic};
}

// Collar bone, breast and shoulder blade of a lean man; `q` has x to his right.
float trunk_skin(glm::vec3 p)
{
    const glm::vec2 q(-p.x, p.y);
    float g = 226;
    if (p.z > 0) {
        g -= 16 * spot(to_segment(q, {0.016f, 1.412f}, {0.110f, 1.436f}), 0.016f);  // below the collar bone
        g += 8 * spot(to_segment(q, {0.012f, 1.428f}, {0.120f, 1.450f}), 0.010f);
        g -= 14 * spot(q, {0, 1.408f}, {0.012f, 0.014f});                           // pit of the throat
        g -= 18 * spot(q.x, 0.012f) * smoothstep(1.43f, 1.38f, p.y);                // breast bone
        g -= 28 * spot(to_segment(q, {0.020f, 1.306f}, {0.104f, 1.312f}), 0.014f);  // below the breast
        g -= 24 * spot(to_segment(q, {0.104f, 1.312f}, {0.136f, 1.372f}), 0.012f);  // and beside it
        g += 12 * spot(q, {0.066f, 1.355f}, {0.040f, 0.034f});
        g -= 62 * smoothstep(0.012f, 0.006f, glm::distance(q, {0.084f, 1.336f}));  // nipple
    } else {
        g -= 22 * spot(q.x, 0.010f);                                                // spine
        g -= 24 * spot(to_segment(q, {0.050f, 1.405f}, {0.060f, 1.300f}), 0.014f);  // inner edge of the blade
        g += 10 * spot(q, {0.086f, 1.372f}, {0.036f, 0.044f});
        g -= 16 * spot(to_segment(q, {0.060f, 1.300f}, {0.118f, 1.330f}), 0.014f);
    }
    return g;
}

// Below the shoulder joint the muscle ends in a point between those of the upper arm.
float shoulder_skin(glm::vec3 p)
{
    const glm::vec3 from = mirrored(p, Side::right) - skeleton().joint(Bone::upper_arm);
    const float along = glm::dot(from, arm_direction()), up = glm::dot(from, arm_dorsal());
    float g = 226 + 10 * smoothstep(0.0f, 0.04f, up);
    g -= 20 * spot(std::fabs(from.z) - 0.042f + 0.22f * along, 0.010f) * smoothstep(0.0f, 0.05f, along);
    return g - 14 * smoothstep(-0.01f, -0.04f, up);
}

}  // namespace

Paint paint_exomis(const Texel &t)
{
    const glm::vec3 p = t.position;
    if (t.chart == Chart::tunic_inside || t.chart == Chart::sleeve_inside) return {150, Zone::tunic};
    if (t.chart == Chart::sleeve_r) return {shoulder_skin(p), Zone::skin};
    const float inside = inside_cloth(t);
    if (inside < 0) return {trunk_skin(p) - 70 * spot(inside, 0.014f), Zone::skin};
    const float weave = 14 * (value_noise(p.x * 420 + p.z * 300, p.y * 420, 231) - 0.5f);  // homespun
    if (t.chart == Chart::sleeve) {
        Paint paint = sleeve(p);
        paint.luminance += weave;
        return paint;
    }
    if (on_rope(t)) return rope(p);
    const float g = weave + (t.st.y < rope_low ? skirt(p) : bodice(p, t.normal));
    const float ragged = 0.004f * value_noise(around(p) * 40, 2, 232);
    const float up = p.y - hem - 0.016f - ragged;
    if (inside < 0.013f) return {g + 10 - 44 * spot(inside - 0.013f, 0.004f), Zone::border};
    if (up < 0) return {g - 34 * spot(up, 0.004f), Zone::border};
    return {g, Zone::tunic};
}

Paint paint_cloak(const Texel &t)
{
    // Folds run along the band.
    const float along = t.st.x, across = t.st.y;
    const float wander = 0.5f * (value_noise(along * 5, across, 233) - 0.5f);
    float g = 220 + 36 * furrow(value_noise(along * 2.4f, (across + wander) * 2.4f, 234)) +
              18 * furrow(value_noise(along * 5, (across + wander) * 6, 235)) +
              14 * (value_noise(along * 300, across * 16, 236) - 0.5f);
    g -= 24 * spot(across, 0.25f) + 24 * spot(across - 3, 0.25f);
    return {g, Zone::outer};
}

}  // namespace claque::figures::plebeian
