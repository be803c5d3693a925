// A young man's face: straight brows, a light beard along the jaw, on chin and upper lip, stubble round it.
#include <glm/vec3.hpp>

#include "lib/figures/brush.h"
#include "lib/figures/plebeian/plebeian.h"

namespace claque::figures::plebeian
{

namespace
{

constexpr glm::vec2 eye_centre(0.0302f, 1.6345f);
constexpr float eye_half = 0.0152f;

struct Eye {
    float inside;  // metres inside the opening, negative outside
    float upper, lower;
};

Eye eye_at(glm::vec2 q)
{
    const float u = (q.x - eye_centre.x) / eye_half;
    const float arch = std::max(0.0f, 1 - u * u);
    const float tilt = 0.0008f * u;
    const float upper = eye_centre.y + tilt + 0.0060f * std::sqrt(arch) * (1 - 0.10f * u);
    const float lower = eye_centre.y + tilt - 0.0046f * arch;
    return {std::fabs(u) < 1 ? std::min(upper - q.y, q.y - lower) : -1, upper, lower};
}

Paint eyeball(glm::vec2 q, const Eye &eye)
{
    const glm::vec2 d = q - (eye_centre + glm::vec2(-0.0004f, 0.0007f));
    const float r = std::sqrt(d.x * d.x + d.y * d.y);
    float grey = 240 - 66 * spot(eye.upper - q.y, 0.0038f) - 40 * smoothstep(0.008f, 0.015f, std::fabs(d.x));
    const float iris = 88 + 48 * smoothstep(0.001f, -0.005f, d.y);
    grey += (iris - grey) * smoothstep(0.0068f, 0.0056f, r);
    grey += (22 - grey) * smoothstep(0.0032f, 0.0022f, r);
    const glm::vec2 glint = d - glm::vec2(0.0019f, 0.0022f);
    grey += (255 - grey) * smoothstep(0.0014f, 0.0007f, std::sqrt(glint.x * glint.x + glint.y * glint.y));
    return {grey, Zone::eyes};
}

bool is_brow(glm::vec2 q)
{
    static const glm::vec2 middle[] = {{0.0100f, 1.6485f}, {0.022f, 1.6525f}, {0.034f, 1.6550f}, {0.050f, 1.6490f}};
    const float half = 0.0036f - 0.0018f * smoothstep(0.022f, 0.050f, q.x);
    const float hairs = 0.0012f * (value_noise(q.x * 1400, 3, 211) - 0.5f);
    return q.x > 0.0100f && q.x < 0.0495f && std::fabs(q.y - profile(middle, q.x)) < half + hairs;
}

constexpr float mouth_half = 0.0238f, mouth_y = 1.5636f;
float mouth_line(float x)
{
    return mouth_y + 0.0012f * (x / mouth_half) * (x / mouth_half) - 0.0008f * spot(x, 0.005f);
}

bool is_lip(glm::vec2 q)
{
    const float u = q.x / mouth_half;
    if (u > 1) return false;
    const float top = mouth_y + 0.0076f * (1 - u * u) - 0.0016f * spot(q.x, 0.0060f) + 0.0010f * u * u;
    const float bottom = mouth_y - 0.0092f * std::sqrt(1 - u * u) * (1 - 0.25f * u) + 0.0010f * u * u;
    return q.y < top && q.y > bottom;
}

Paint lips(glm::vec2 q)
{
    const float from_line = q.y - mouth_line(q.x);
    float g = from_line > 0 ? 198 : 220 + 22 * spot(q, {0.006f, 1.5580f}, {0.011f, 0.0035f});
    g += (92 - g) * smoothstep(0.0017f, 0.0007f, std::fabs(from_line));
    return {g - 18 * smoothstep(0.6f, 1.0f, q.x / mouth_half), Zone::lips};
}

// The thickness of the beard, 0 to 1: from the whiskers along the edge of the jaw to the chin, and on the upper lip. It
// is thin everywhere, since he is young.
float beard(glm::vec3 p)
{
    static const glm::vec2 upper[] = {{-0.010f, 1.560f}, {0.004f, 1.606f}, {0.024f, 1.612f}, {0.040f, 1.576f},
                                      {0.060f, 1.552f},  {0.082f, 1.546f}, {0.200f, 1.547f}};
    const glm::vec2 q(std::fabs(p.x), p.y);
    float thick = smoothstep(0.006f, -0.014f, p.y - profile(upper, p.z)) * smoothstep(-0.012f, 0.020f, p.z);
    thick *= smoothstep(1.496f, 1.524f, p.y + 0.05f * p.z);
    thick *= smoothstep(0.75f, 1.05f, std::max(q.x / 0.030f, std::fabs(p.y - 1.558f) / 0.014f));
    const float lip = spot(to_segment(q, {0.0040f, 1.5762f}, {0.0255f, 1.5695f}), 0.0060f);
    const float corner = spot(to_segment(q, {0.0275f, 1.5660f}, {0.0265f, 1.5460f}), 0.0075f);
    const float under = spot(q, {0, 1.5480f}, {0.0080f, 0.0066f});
    return std::max({0.84f * thick, 0.86f * lip, 0.58f * corner, 0.70f * under});
}

float skin_of_face(glm::vec2 q, glm::vec3 n)
{
    float g = 228;
    g += 13 * spot(q, {0, 1.610f}, {0.007f, 0.042f});                                // ridge of the nose
    g += 10 * spot(q, {0.047f, 1.606f}, {0.022f, 0.014f});                           // cheekbone
    g += 8 * spot(q, {0, 1.678f}, {0.050f, 0.020f});                                 // forehead
    g -= 36 * spot(q, {0.0138f, 1.638f}, {0.0082f, 0.014f});                         // beside the root of the nose
    g -= 24 * spot(q, {0.0310f, 1.6440f}, {0.021f, 0.0066f});                        // under the brow
    g -= 14 * spot(q, {0.0300f, 1.6235f}, {0.016f, 0.0066f});                        // under the eye
    g -= 18 * spot(q, {0.0130f, 1.607f}, {0.0066f, 0.022f});                         // side of the nose
    g -= 22 * spot(q, {0.0520f, 1.576f}, {0.018f, 0.026f});                          // hollow of the cheek
    g -= 26 * spot(to_segment(q, {0.0178f, 1.5985f}, {0.0182f, 1.5890f}), 0.0034f);  // wing of the nose
    g -= 18 * spot(q, {0, 1.5800f}, {0.0034f, 0.0060f});                             // groove of the upper lip
    g -= 44 * spot(q, {0, 1.5810f}, {0.0145f, 0.0048f}) * smoothstep(0.3f, -0.4f, n.y);
    g -= 20 * spot(q, {0, 1.5490f}, {0.0170f, 0.0052f});  // below the lower lip
    return g;
}

Paint face(glm::vec3 p, glm::vec3 n)
{
    const glm::vec2 q(std::fabs(p.x), p.y);
    const Eye eye = eye_at(q);
    if (eye.inside > 0) return eyeball(q, eye);
    if (is_brow(q)) return {140 + 70 * value_noise(p.x * 900, p.y * 260, 212), Zone::hair};
    if (is_lip(q)) return lips(q);
    float g = skin_of_face(q, n);
    const float u = (q.x - eye_centre.x) / eye_half;
    if (u > -1.04f && u < 1.06f) {
        const float above = q.y - eye.upper, below = eye.lower - q.y;
        if (above > -0.0008f) g += (70 - g) * smoothstep(0.0022f, 0.0008f, above);  // lashes
        g -= 40 * spot(above - 0.0050f, 0.0018f) * (1 - 0.6f * u * u);              // crease of the lid
        if (below > -0.0008f) g -= 56 * smoothstep(0.0015f, 0.0004f, below);
    }
    if (spot(q, {0.0068f, 1.5855f}, {0.0044f, 0.0028f}) > 0.25f && n.y < 0.25f) g = 92;  // nostril
    return {g, Zone::skin};
}

float paint_throat(glm::vec3 p)
{
    const float side = std::fabs(p.x), low = smoothstep(1.520f, 1.490f, p.y);
    float g = 226;
    g -= 18 * spot(to_segment({side, p.y}, {0.014f, 1.44f}, {0.050f, 1.53f}) - 0.010f, 0.014f) * low;
    g += 12 * spot(glm::vec2(side, p.y), {0, 1.482f}, {0.010f, 0.014f}) * smoothstep(0.0f, 0.03f, p.z);  // Adam's apple
    return g;
}

}  // namespace

Paint paint_lean_head(const Texel &t)
{
    const glm::vec3 p = t.position;
    if (t.chart != Chart::head) {
        const float hollow = spot(glm::vec2(p.z, p.y), {0.000f, 1.620f}, {0.012f, 0.020f});
        const float rim = spot(glm::vec2(p.z, p.y), {-0.004f, 1.636f}, {0.007f, 0.012f});
        return {216 - 76 * hollow - 18 * rim, Zone::skin};
    }
    const float above = p.y - hair_edge(p);
    if (p.y > 1.515f && above > 0) return paint_hair(t);
    Paint paint = p.z > 0.026f && p.y > 1.512f ? face(p, t.normal) : Paint{paint_throat(p), Zone::skin};
    if (paint.zone != Zone::skin) return paint;
    // Single hairs where the beard is thin, a shade of stubble about them.
    const float thick = beard(p), hairs = value_noise(p.x * 700, p.y * 520 + p.z * 400, 213);
    if (thick > 0.34f + 0.62f * hairs)
        return {196 + 58 * value_noise(p.x * 620 + 9, p.y * 330 + p.z * 300, 214), Zone::hair};
    paint.luminance -= 62 * thick + 34 * spot(above, 0.010f) * (p.y > 1.53f ? 1.0f : 0.0f);
    return paint;
}

}  // namespace claque::figures::plebeian
