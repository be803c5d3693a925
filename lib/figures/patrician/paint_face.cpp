// A woman's face: large eyes under drawn brows, lids lined with kohl, a soft cheek, full lips.
#include <glm/vec3.hpp>

#include "lib/figures/brush.h"
#include "lib/figures/patrician/paint.h"
#include "lib/figures/patrician/patrician.h"

namespace claque::figures::patrician
{

namespace
{

constexpr glm::vec2 eye_centre(0.0310f, 1.6340f);
constexpr float eye_half = 0.0165f;

struct Eye {
    float inside;  // metres inside the opening, negative outside
    float upper, lower;
};

Eye eye_at(glm::vec2 q)
{
    const float u = (q.x - eye_centre.x) / eye_half;
    const float arch = std::max(0.0f, 1 - u * u);
    const float tilt = 0.0013f * u;  // the outer corner is higher
    const float upper = eye_centre.y + tilt + 0.0072f * std::sqrt(arch) * (1 - 0.10f * u);
    const float lower = eye_centre.y + tilt - 0.0052f * arch;
    return {std::fabs(u) < 1 ? std::min(upper - q.y, q.y - lower) : -1, upper, lower};
}

Paint eyeball(glm::vec2 q, const Eye &eye)
{
    const glm::vec2 d = q - (eye_centre + glm::vec2(-0.0006f, 0.0009f));
    const float r = std::sqrt(d.x * d.x + d.y * d.y);
    float grey = 244 - 70 * spot(eye.upper - q.y, 0.0042f) - 40 * smoothstep(0.009f, 0.016f, std::fabs(d.x));
    const float iris = 92 + 60 * smoothstep(0.001f, -0.005f, d.y);
    grey += (iris - grey) * smoothstep(0.0074f, 0.0062f, r);
    grey -= 40 * spot(r - 0.0064f, 0.0012f);
    grey += (20 - grey) * smoothstep(0.0034f, 0.0024f, r);
    const glm::vec2 glint = d - glm::vec2(0.0020f, 0.0026f);
    grey += (255 - grey) * smoothstep(0.0016f, 0.0008f, std::sqrt(glint.x * glint.x + glint.y * glint.y));
    return {grey, Zone::eyes};
}

bool is_brow(glm::vec2 q)
{
    static const glm::vec2 middle[] = {{0.0130f, 1.6510f}, {0.024f, 1.6555f}, {0.036f, 1.6580f}, {0.052f, 1.6500f}};
    const float half = 0.0024f - 0.0013f * smoothstep(0.026f, 0.052f, q.x);
    return q.x > 0.0130f && q.x < 0.0520f && std::fabs(q.y - profile(middle, q.x)) < half;
}

constexpr float mouth_half = 0.0218f, mouth_y = 1.5680f;
float mouth_line(float x)
{
    return mouth_y + 0.0026f * (x / mouth_half) * (x / mouth_half) - 0.0010f * spot(x, 0.006f);
}

bool is_lip(glm::vec2 q)
{
    const float u = q.x / mouth_half;
    if (u > 1) return false;
    const float top = mouth_y + 0.0092f * (1 - u * u) - 0.0020f * spot(q.x, 0.0062f) + 0.0022f * u * u;
    const float bottom = mouth_y - 0.0108f * std::sqrt(1 - u * u) * (1 - 0.25f * u) + 0.0022f * u * u;
    return q.y < top && q.y > bottom;
}

float skin_of_face(glm::vec2 q, glm::vec3 n)
{
    float g = 234;
    g += 10 * spot(q, {0, 1.612f}, {0.007f, 0.040f});                                // ridge of the nose
    g += 9 * spot(q, {0, 1.601f}, {0.007f, 0.007f});                                 // its tip
    g += 8 * spot(q, {0.046f, 1.606f}, {0.026f, 0.018f});                            // cheek
    g += 6 * spot(q, {0, 1.680f}, {0.050f, 0.020f});                                 // forehead
    g += 8 * spot(q, {0, 1.538f}, {0.014f, 0.010f});                                 // chin
    g -= 26 * spot(q, {0.0140f, 1.640f}, {0.0080f, 0.014f});                         // beside the root of the nose
    g -= 22 * spot(q, {0.0320f, 1.6450f}, {0.021f, 0.0060f});                        // eyelid
    g -= 10 * spot(q, {0.0300f, 1.6220f}, {0.016f, 0.0060f});                        // under the eye
    g -= 14 * spot(q, {0.0125f, 1.608f}, {0.0060f, 0.022f});                         // side of the nose
    g -= 12 * spot(q, {0.0560f, 1.574f}, {0.020f, 0.026f});                          // hollow of the cheek
    g -= 14 * spot(to_segment(q, {0.0145f, 1.6000f}, {0.0150f, 1.5945f}), 0.0042f);  // wing of the nose
    g -= 16 * spot(q, {0, 1.5835f}, {0.0032f, 0.0060f});                             // groove of the upper lip
    g -= 30 * spot(q, {0, 1.5870f}, {0.0130f, 0.0045f}) * smoothstep(0.3f, -0.4f, n.y);
    g -= 22 * spot(q, {0, 1.5545f}, {0.0160f, 0.0050f});        // below the lower lip
    g -= 14 * spot(q, {0.0250f, 1.5685f}, {0.0055f, 0.0060f});  // corner of the mouth
    return g;
}

Paint lips(glm::vec2 q)
{
    const float from_line = q.y - mouth_line(q.x);
    float g = from_line > 0 ? 204 : 226 + 26 * spot(q, {0.005f, 1.5620f}, {0.011f, 0.0035f});
    g += (100 - g) * smoothstep(0.0016f, 0.0006f, std::fabs(from_line));
    return {g - 16 * smoothstep(0.6f, 1.0f, q.x / mouth_half), Zone::lips};
}

Paint face(glm::vec3 p, glm::vec3 n)
{
    const glm::vec2 q(std::fabs(p.x), p.y);
    const Eye eye = eye_at(q);
    if (eye.inside > 0) return eyeball(q, eye);
    if (is_brow(q)) return {168 + 50 * value_noise(p.x * 900, p.y * 260, 107), Zone::hair};
    if (is_lip(q)) return lips(q);
    float g = skin_of_face(q, n);
    // Kohl: a dark line on the upper lid that extends beyond the outer corner, a thin one below.
    const float u = (q.x - eye_centre.x) / eye_half;
    if (u > -1.04f && u < 1.04f) {
        const float above = q.y - eye.upper, below = eye.lower - q.y;
        if (above > -0.0010f) g += (58 - g) * smoothstep(0.0028f, 0.0010f, above);
        g -= 34 * spot(above - 0.0062f, 0.0018f) * (1 - 0.6f * u * u);  // crease of the lid
        if (below > -0.0010f) g -= 90 * smoothstep(0.0018f, 0.0004f, below) * smoothstep(-1.0f, 0.3f, u);
    }
    g -= 120 * spot(to_segment(q, {0.0470f, 1.6352f}, {0.0520f, 1.6378f}), 0.0018f);
    if (spot(q, {0.0062f, 1.5905f}, {0.0042f, 0.0026f}) > 0.25f && n.y < 0.25f) g = 110;  // nostril
    return {g, Zone::skin};
}

// Throat and breast, with a necklace of beads and a pendant.
Paint paint_throat(glm::vec3 p)
{
    const float side = std::fabs(p.x), low = smoothstep(1.520f, 1.480f, p.y);
    float g = 234 - 8 * spot(p.y - 1.505f, 0.03f) * smoothstep(0, 0.03f, p.z);
    g -= 10 * spot(to_segment({side, p.y}, {0.012f, 1.43f}, {0.046f, 1.53f}) - 0.010f, 0.014f) * low;
    g -= 14 * spot(to_segment({side, p.y}, {0.010f, 1.428f}, {0.090f, 1.446f}), 0.008f);  // collar bones
    if (p.z < 0) return {g, Zone::skin};
    const float hang = 1.434f + 3.2f * side * side;
    const float chain = p.y - hang;
    const float bead = std::fabs(std::fmod(side * 100 + 0.5f, 1.0f) - 0.5f);
    if (std::fabs(chain) < 0.0052f - 0.003f * bead * bead && side < 0.085f)
        return {232 - 120 * bead - 30 * spot(chain + 0.004f, 0.003f), Zone::jewellery};
    const glm::vec2 drop((p.x) / 0.008f, (p.y - 1.418f) / 0.012f);
    const float d = drop.x * drop.x + drop.y * drop.y;
    if (d < 1)
        return {d < 0.35f ? 150 + 90 * spot(drop - glm::vec2(-0.2f, 0.25f), {0, 0}, {0.4f, 0.4f}) : 236,
                Zone::jewellery};
    return {g - 40 * spot(chain + 0.006f, 0.004f), Zone::skin};
}

}  // namespace

Paint paint_lady_head(const Texel &t)
{
    const glm::vec3 p = t.position;
    if (t.chart != Chart::head) {
        const float hollow = spot(glm::vec2(p.z, p.y), {-0.004f, 1.618f}, {0.012f, 0.018f});
        return {222 - 60 * hollow, Zone::skin};
    }
    const float above = p.y - hair_edge(p);
    if (p.y > 1.535f && above > 0) return paint_hair(t);
    if (p.z > 0.026f && p.y > 1.522f) {
        Paint paint = face(p, t.normal);
        if (paint.zone == Zone::skin) paint.luminance -= 42 * spot(above, 0.009f);
        return paint;
    }
    Paint paint = paint_throat(p);
    if (paint.zone == Zone::skin && p.y > 1.54f) paint.luminance -= 30 * spot(above, 0.008f);
    return paint;
}

}  // namespace claque::figures::patrician
