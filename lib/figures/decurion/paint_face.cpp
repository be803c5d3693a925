// An old man's face: small eyes under heavy lids with bags below, furrows on the brow, deep folds from the nose to the
// mouth and on to the jowls, thin lips.
#include <glm/vec3.hpp>

#include "lib/figures/brush.h"
#include "lib/figures/decurion/decurion.h"
#include "lib/figures/decurion/paint.h"

namespace claque::figures::decurion
{

namespace
{

constexpr glm::vec2 eye_centre(0.0320f, 1.6335f);
constexpr float eye_half = 0.0150f;

struct Eye {
    float inside;  // metres inside the opening, negative outside
    float upper, lower;
};

Eye eye_at(glm::vec2 q)
{
    const float u = (q.x - eye_centre.x) / eye_half;
    const float arch = std::max(0.0f, 1 - u * u);
    const float tilt = -0.0008f * u;  // the outer corner is lower
    const float upper = eye_centre.y + tilt + 0.0046f * std::sqrt(arch) * (1 - 0.26f * u);
    const float lower = eye_centre.y + tilt - 0.0044f * arch;
    return {std::fabs(u) < 1 ? std::min(upper - q.y, q.y - lower) : -1, upper, lower};
}

Paint eyeball(glm::vec2 q, const Eye &eye)
{
    const glm::vec2 d = q - (eye_centre + glm::vec2(-0.0004f, 0.0004f));
    const float r = std::sqrt(d.x * d.x + d.y * d.y);
    float grey = 222 - 80 * spot(eye.upper - q.y, 0.0036f) - 50 * smoothstep(0.007f, 0.014f, std::fabs(d.x));
    const float iris = 74 + 40 * smoothstep(0.001f, -0.004f, d.y);
    grey += (iris - grey) * smoothstep(0.0064f, 0.0054f, r);
    grey -= 36 * spot(r - 0.0056f, 0.0011f);
    grey += (20 - grey) * smoothstep(0.0030f, 0.0021f, r);
    const glm::vec2 glint = d - glm::vec2(0.0018f, 0.0020f);
    grey += (255 - grey) * smoothstep(0.0014f, 0.0007f, std::sqrt(glint.x * glint.x + glint.y * glint.y));
    return {grey, Zone::eyes};
}

// Bushy, with single hairs.
bool is_brow(glm::vec3 p)
{
    static const glm::vec2 middle[] = {{0.0100f, 1.6480f}, {0.022f, 1.6525f}, {0.036f, 1.6545f}, {0.054f, 1.6450f}};
    const float x = std::fabs(p.x);
    const float half =
        0.0050f - 0.0024f * smoothstep(0.030f, 0.054f, x) + 0.0024f * (value_noise(p.x * 700, p.y * 200, 311) - 0.5f);
    return x > 0.0100f && x < 0.0535f && std::fabs(p.y - profile(middle, x)) < half;
}

constexpr float mouth_half = 0.0275f, mouth_y = 1.5620f;
float mouth_line(float x) { return mouth_y - 0.0010f * (x / mouth_half) * (x / mouth_half); }

bool is_lip(glm::vec2 q)
{
    const float u = q.x / mouth_half;
    if (u > 1) return false;
    const float line = mouth_line(q.x);
    const float top = line + 0.0058f * (1 - u * u) - 0.0012f * spot(q.x, 0.0060f);
    const float bottom = line - 0.0072f * std::sqrt(1 - u * u) * (1 - 0.35f * u);
    return q.y < top && q.y > bottom;
}

// Large areas of light and dark.
float relief(glm::vec2 q, glm::vec3 n)
{
    float g = 220;
    g += 18 * spot(q, {0, 1.612f}, {0.008f, 0.040f});                                // ridge of the nose
    g += 12 * spot(q, {0, 1.592f}, {0.011f, 0.010f});                                // its tip
    g += 14 * spot(q, {0.050f, 1.604f}, {0.022f, 0.014f});                           // cheekbone
    g += 12 * spot(q, {0, 1.700f}, {0.060f, 0.030f});                                // forehead
    g += 10 * spot(q, {0, 1.532f}, {0.018f, 0.010f});                                // chin
    g += 10 * spot(q, {0.050f, 1.548f}, {0.016f, 0.016f});                           // jowl
    g -= 52 * spot(q, {0.0145f, 1.637f}, {0.0090f, 0.014f});                         // beside the root of the nose
    g -= 34 * spot(q, {0.0330f, 1.6425f}, {0.024f, 0.0080f});                        // under the brow
    g -= 24 * spot(q, {0.0150f, 1.605f}, {0.0070f, 0.022f});                         // side of the nose
    g -= 20 * spot(q, {0.0540f, 1.576f}, {0.016f, 0.024f});                          // hollow of the cheek
    g -= 36 * spot(to_segment(q, {0.0205f, 1.5985f}, {0.0210f, 1.5865f}), 0.0038f);  // wing of the nose
    g -= 24 * spot(q, {0, 1.5760f}, {0.0036f, 0.0065f});                             // groove of the upper lip
    g -= 50 * spot(q, {0, 1.5800f}, {0.0160f, 0.0050f}) * smoothstep(0.3f, -0.4f, n.y);
    g -= 30 * spot(q, {0, 1.5475f}, {0.0200f, 0.0055f});     // below the lower lip
    g -= 10 * spot(q, {0.0f, 1.540f}, {0.065f, 0.042f});     // shaven beard
    g -= 34 * spot(q, {0.0010f, 1.512f}, {0.040f, 0.007f});  // between chin and double chin
    return g;
}

// Wrinkles. q is mirrored; x distinguishes left and right, so that the halves differ a little.
float wrinkles(glm::vec2 q, float x)
{
    const float wave = 0.0016f * (value_noise(x * 70 + 20, 3, 312) - 0.5f);
    float g = 0;
    // Brow: four furrows that sink towards the temples.
    const float sink = 1.9f * q.x * q.x;
    for (const glm::vec2 line : {glm::vec2(1.6690f, 30), {1.6785f, 38}, {1.6885f, 32}, {1.6990f, 20}})
        g -= line.y * spot(q.y - line.x + sink - 2 * wave, 0.0019f) * smoothstep(0.056f, 0.034f, q.x);
    g -= 46 * spot(to_segment(q, {0.0062f, 1.661f}, {0.0050f, 1.644f}), 0.0022f);  // frown
    g -= 26 * spot(to_segment(q, {0.0000f, 1.640f}, {0.0090f, 1.6385f}), 0.0020f);
    // Crow's feet.
    g -= 0.7f * 36 * spot(to_segment(q, {0.0490f, 1.6335f}, {0.0620f, 1.6400f}), 0.0018f);
    g -= 0.7f * 40 * spot(to_segment(q, {0.0490f, 1.6315f}, {0.0635f, 1.6310f}), 0.0018f);
    g -= 0.7f * 34 * spot(to_segment(q, {0.0480f, 1.6290f}, {0.0610f, 1.6215f}), 0.0018f);
    // Bags: a furrow round the lower lid's swelling.
    const glm::vec2 d = (q - glm::vec2(0.0315f, 1.6280f)) / glm::vec2(0.0185f, 0.0130f);
    const float ring = std::sqrt(d.x * d.x + d.y * d.y);
    if (q.y < 1.6280f)
        g += (-30 * spot(ring - 1, 0.24f) + 8 * spot(ring - 0.70f, 0.25f)) * smoothstep(1.6285f, 1.6230f, q.y);
    // From the nose to the mouth, from the mouth's corners down, and a second fold in the cheek.
    const float fold = std::min(to_segment(q, {0.0225f, 1.5960f}, {0.0350f, 1.5760f}),
                                to_segment(q, {0.0350f, 1.5760f}, {0.0385f, 1.5580f}));
    g -= 58 * spot(fold, 0.0040f);
    g += 12 * spot(fold - 0.006f, 0.005f) * smoothstep(0.024f, 0.034f, q.x);
    g -= 44 * spot(to_segment(q, {0.0285f, 1.5590f}, {0.0330f, 1.5400f}), 0.0034f);
    g -= 22 * spot(to_segment(q, {0.0470f, 1.5860f}, {0.0500f, 1.5600f}), 0.0030f);
    g -= 16 * spot(to_segment(q, {0.0060f, 1.5720f}, {0.0075f, 1.5660f}), 0.0016f);
    g -= 16 * spot(to_segment(q, {0.0140f, 1.5700f}, {0.0160f, 1.5640f}), 0.0016f);
    return g;
}

float blotches(glm::vec3 p)
{
    const float age = value_noise(p.x * 130 + 60, p.y * 130, 313);
    return -14 * smoothstep(0.80f, 0.93f, age) + 8 * (value_noise(p.x * 420, p.y * 420, 314) - 0.5f);
}

Paint lips(glm::vec2 q)
{
    const float from_line = q.y - mouth_line(q.x);
    float g = from_line > 0 ? 190 : 212 + 22 * spot(q, {0.006f, 1.5575f}, {0.012f, 0.0030f});
    g += (86 - g) * smoothstep(0.0018f, 0.0007f, std::fabs(from_line));
    return {g - 20 * smoothstep(0.6f, 1.0f, q.x / mouth_half), Zone::lips};
}

Paint face(glm::vec3 p, glm::vec3 n)
{
    const glm::vec2 q(std::fabs(p.x), p.y);
    const Eye eye = eye_at(q);
    if (eye.inside > 0) return eyeball(q, eye);
    if (is_brow(p)) return {168 + 70 * value_noise(p.x * 900, p.y * 260, 307), Zone::hair};
    if (is_lip(q)) return lips(q);
    float g = relief(q, n) + wrinkles(q, p.x) + blotches(p);
    if (std::fabs(q.x - eye_centre.x) < eye_half + 0.0015f) {
        const float above = q.y - eye.upper, below = eye.lower - q.y;
        if (above > -0.0006f) g += (62 - g) * smoothstep(0.0024f, 0.0009f, above);
        g -= 54 * spot(above - 0.0044f, 0.0020f) * (above > 0.0014f ? 1 : 0);  // the lid hangs over its crease
        if (below > -0.0005f) g -= 60 * smoothstep(0.0016f, 0.0004f, below);
    }
    if (spot(q, {0.0078f, 1.5835f}, {0.0050f, 0.0030f}) > 0.25f && n.y < 0.25f) g = 84;  // nostril
    return {g, Zone::skin};
}

// Windpipe, slack cords and creases of a thick neck.
float neck(glm::vec3 p)
{
    const float side = std::fabs(p.x), low = smoothstep(1.525f, 1.490f, p.y), ahead = smoothstep(-0.02f, 0.03f, p.z);
    float g = 218 + blotches(p);
    g -= 26 * spot(to_segment({side, p.y}, {0.010f, 1.44f}, {0.024f, 1.515f}) - 0.004f, 0.009f) * low * ahead;
    g -= 18 * spot(to_segment({side, p.y}, {0.030f, 1.44f}, {0.060f, 1.53f}), 0.012f) * low;
    for (const float crease_y : {1.458f, 1.478f, 1.496f})
        g -= 22 * spot(p.y - crease_y - 1.5f * side * side, 0.0035f) * ahead;
    const bool nape = p.z < -0.03f;
    if (nape)
        for (const float crease_y : {1.500f, 1.518f}) g -= 26 * spot(p.y - crease_y, 0.005f);
    return g;
}

}  // namespace

Paint paint_aged_head(const Texel &t)
{
    const glm::vec3 p = t.position;
    if (t.chart != Chart::head) {
        const float hollow = spot(glm::vec2(p.z, p.y), {-0.004f, 1.618f}, {0.013f, 0.023f});
        const float rim = spot(glm::vec2(p.z, p.y), {-0.008f, 1.637f}, {0.007f, 0.014f});
        return {208 - 84 * hollow - 20 * rim, Zone::skin};
    }
    const float above = p.y - hair_edge(p);
    if (p.y > 1.54f && above > 0) return paint_aged_hair(t);
    Paint paint;
    if (p.z > 0.030f && p.y > 1.510f) paint = face(p, t.normal);
    else if (p.y > 1.66f) paint = {226 + blotches(p), Zone::skin};
    else paint = {neck(p), Zone::skin};
    if (paint.zone == Zone::skin && p.y > 1.54f) paint.luminance -= 34 * spot(above, 0.010f);
    return paint;
}

}  // namespace claque::figures::decurion
