// Paints the citizen's face, neck, ears and hair.
#include <glm/vec3.hpp>

#include "lib/figures/brush.h"
#include "lib/figures/painters.h"

namespace claque::figures
{

namespace
{

// The height of the hairline, by the point's position from front to back: fringe, temple, whisker, round the ear, nape.
float hairline(glm::vec3 p)
{
    static const glm::vec2 line[] = {{-0.085f, 1.556f}, {-0.060f, 1.562f}, {-0.036f, 1.580f}, {-0.030f, 1.636f},
                                     {-0.012f, 1.655f}, {0.008f, 1.650f},  {0.012f, 1.622f},  {0.024f, 1.624f},
                                     {0.034f, 1.662f},  {0.050f, 1.694f},  {0.070f, 1.706f},  {0.100f, 1.704f}};
    const float jag = value_noise(p.x * 160 + 40, p.z * 120, 1) - 0.5f;
    return profile(line, p.z) + jag * (p.z > 0.04f ? 0.010f : 0.006f);
}

// Comma-shaped locks in rows that overlap like tiles, combed from the crown outwards.
Paint hair(glm::vec3 p)
{
    const float dx = p.x, dz = p.z + 0.02f;
    const float round = dx / (std::fabs(dx) + std::fabs(dz) + 0.004f);
    const float far = std::sqrt(dx * dx + dz * dz) + 0.9f * (1.76f - p.y);
    const float v = far * 34 + 0.8f * value_noise(round * 5 + 9, far * 9, 2);
    const float row = std::floor(v), down = v - row;
    const float bend = 0.42f * down * down * (value_noise(row * 0.7f, round * 2 + 5, 5) > 0.5f ? 1.0f : -1.0f);
    const float u = (dz < 0 ? 40 + round : round) * 8.5f + 0.5f * row + bend + 0.35f * value_noise(row * 3.1f, 7, 6);
    const float across = u - std::floor(u);
    const float shade = value_noise(std::floor(u) * 1.7f, row * 2.3f, 3);
    const float strand = value_noise(u * 6, v * 0.8f, 4);
    const float round_lock = 1 - 4 * (across - 0.5f) * (across - 0.5f);
    const float edge = smoothstep(0, 0.016f, p.y - hairline(p));
    const float g = 118 + 62 * round_lock + 34 * (1 - down) + 30 * (shade - 0.5f) + 42 * strand - 26 * (1 - edge);
    return {g, Zone::hair};
}

struct Eye {
    float inside;  // metres inside the opening, negative outside
    float upper, lower;
};

constexpr glm::vec2 eye_centre(0.0315f, 1.6345f);
constexpr float eye_half = 0.0150f;

Eye eye_at(glm::vec2 q)
{
    const float u = (q.x - eye_centre.x) / eye_half;
    const float arch = std::max(0.0f, 1 - u * u);
    const float tilt = 0.0010f * u;
    const float upper = eye_centre.y + tilt + 0.0058f * std::sqrt(arch) * (1 - 0.12f * u);
    const float lower = eye_centre.y + tilt - 0.0044f * arch;
    return {std::fabs(u) < 1 ? std::min(upper - q.y, q.y - lower) : -1, upper, lower};
}

Paint eyeball(glm::vec2 q, const Eye &eye)
{
    const glm::vec2 d = q - (eye_centre + glm::vec2(-0.0004f, 0.0006f));
    const float r = std::sqrt(d.x * d.x + d.y * d.y);
    float grey = 236 - 60 * spot(eye.upper - q.y, 0.0035f) - 40 * smoothstep(0.008f, 0.014f, std::fabs(d.x));
    if (r < 0.0062f) grey = r < 0.0026f ? 22 : r < 0.0050f ? 104 + 30 * smoothstep(0, -0.004f, d.y) : 58;
    if (std::fabs(d.x - 0.0018f) < 0.0009f && std::fabs(d.y - 0.0020f) < 0.0009f) grey = 255;
    return {grey, Zone::eyes};
}

bool is_brow(glm::vec2 q)
{
    static const glm::vec2 middle[] = {{0.0115f, 1.6480f}, {0.022f, 1.6530f}, {0.034f, 1.6560f}, {0.050f, 1.6500f}};
    const float half = 0.0036f - 0.0016f * smoothstep(0.024f, 0.050f, q.x);
    return q.x > 0.0105f && q.x < 0.0505f && std::fabs(q.y - profile(middle, q.x)) < half;
}

// Positive inside, in metres; upper and lower lip meet at the mouth line.
constexpr float mouth_half = 0.0265f;
float mouth_line(float x) { return 1.5634f + 0.0016f * x / mouth_half * x / mouth_half; }

bool is_lip(glm::vec2 q)
{
    const float u = q.x / mouth_half;
    if (u > 1) return false;
    const float top = 1.5634f + 0.0082f * (1 - u * u) - 0.0016f * spot(q.x, 0.0060f);
    const float bottom = 1.5634f - 0.0090f * std::sqrt(1 - u * u) * (1 - 0.25f * u);
    return q.y < top && q.y > bottom;
}

float face_shade(glm::vec2 q, glm::vec3 n)
{
    float g = 226;
    g += 16 * spot(q, {0, 1.608f}, {0.008f, 0.045f});                                // ridge of the nose
    g += 12 * spot(q, {0.050f, 1.606f}, {0.022f, 0.014f});                           // cheekbone
    g += 8 * spot(q, {0, 1.682f}, {0.050f, 0.022f});                                 // forehead
    g += 8 * spot(q, {0, 1.530f}, {0.016f, 0.012f});                                 // chin
    g -= 44 * spot(q, {0.0140f, 1.638f}, {0.0085f, 0.014f});                         // beside the root of the nose
    g -= 26 * spot(q, {0.0320f, 1.6440f}, {0.022f, 0.0075f});                        // under the brow
    g -= 22 * spot(q, {0.0310f, 1.6235f}, {0.016f, 0.0070f});                        // under the eye
    g -= 20 * spot(q, {0.0135f, 1.606f}, {0.0070f, 0.022f});                         // side of the nose
    g -= 14 * spot(q, {0.0560f, 1.572f}, {0.018f, 0.028f});                          // hollow of the cheek
    g -= 32 * spot(to_segment(q, {0.0185f, 1.5985f}, {0.0190f, 1.5885f}), 0.0036f);  // wing of the nose
    g -= 20 * spot(to_segment(q, {0.0200f, 1.5900f}, {0.0320f, 1.5665f}), 0.0050f);  // fold to the mouth
    g -= 26 * spot(q, {0, 1.5785f}, {0.0036f, 0.0065f});                             // groove of the upper lip
    g -= 50 * spot(q, {0, 1.5800f}, {0.0150f, 0.0050f}) * smoothstep(0.3f, -0.4f, n.y);
    g -= 24 * spot(q, {0, 1.5490f}, {0.0180f, 0.0055f});                          // below the lower lip
    g -= 14 * spot(q, {0.0285f, 1.5620f}, {0.0060f, 0.0070f});                    // corner of the mouth
    g -= 8 * spot(q, {0.0f, 1.538f}, {0.06f, 0.040f});                            // shaven beard
    g -= 14 * spot(to_segment(q, {0.0020f, 1.672f}, {0.036f, 1.675f}), 0.0022f);  // lines of the forehead
    g -= 20 * spot(to_segment(q, {0.0060f, 1.657f}, {0.0052f, 1.646f}), 0.0020f);
    return g;
}

Paint face(glm::vec3 p, glm::vec3 n)
{
    const glm::vec2 q(std::fabs(p.x), p.y);
    const Eye eye = eye_at(q);
    if (eye.inside > 0) return eyeball(q, eye);
    const bool over_eye = std::fabs(q.x - eye_centre.x) < eye_half + 0.0015f;
    if (is_brow(q)) return {150 + 60 * value_noise(p.x * 900, p.y * 260, 7), Zone::hair};
    if (is_lip(q)) {
        const float from_line = q.y - mouth_line(q.x);
        float g = from_line > 0 ? 196 : 216 + 24 * spot(q, {0.006f, 1.5585f}, {0.012f, 0.0035f});
        if (std::fabs(from_line) < 0.0012f) g = 92;
        return {g - 20 * smoothstep(0.6f, 1.0f, q.x / mouth_half), Zone::lips};
    }
    float g = face_shade(q, n);
    if (over_eye) {
        const float above = q.y - eye.upper, below = eye.lower - q.y;
        if (above >= -0.0004f && above < 0.0016f) g = 74;                      // lashes
        g -= 46 * spot(above - 0.0046f, 0.0017f) * (above > 0.0016f ? 1 : 0);  // crease of the lid
        if (below >= 0 && below < 0.0011f) g = std::min(g, 168.0f);
    }
    if (spot(q, {0.0072f, 1.5850f}, {0.0046f, 0.0030f}) > 0.25f && n.y < 0.25f) g = 86;  // nostril
    return {g, Zone::skin};
}

}  // namespace

Paint paint_head(const Texel &t)
{
    const glm::vec3 p = t.position;
    if (t.chart != Chart::head) {
        const float hollow = spot(glm::vec2(p.z, p.y), {-0.004f, 1.620f}, {0.012f, 0.020f});
        const float rim = spot(glm::vec2(p.z, p.y), {-0.008f, 1.636f}, {0.007f, 0.012f});
        return {216 - 80 * hollow - 18 * rim, Zone::skin};
    }
    if (p.y > 1.54f && p.y > hairline(p)) return hair(p);
    if (p.z > 0.030f && p.y > 1.512f) return face(p, t.normal);
    float g =
        226 - 8 * spot(glm::vec2(std::fabs(p.x), p.y), {0.0f, 1.538f}, {0.06f, 0.040f}) * smoothstep(0, 0.03f, p.z);
    {  // neck: windpipe and the muscles beside it
        const float side = std::fabs(p.x), low = smoothstep(1.520f, 1.490f, p.y);
        g -= 16 * spot(to_segment({side, p.y}, {0.014f, 1.44f}, {0.050f, 1.53f}) - 0.010f, 0.014f) * low;
        g += 10 * spot(glm::vec2(side, p.y), {0, 1.47f}, {0.012f, 0.016f}) * low;
    }
    // A slight shadow where hair meets skin.
    return {g - 30 * spot(hairline(p) - p.y, 0.008f) * (p.y > 1.54f ? 1 : 0), Zone::skin};
}

}  // namespace claque::figures
