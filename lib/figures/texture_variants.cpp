#include "lib/figures/texture_variants.h"

#include <glm/vec3.hpp>

#include "lib/figures/brush.h"
#include "lib/figures/decurion/decurion.h"
#include "lib/figures/decurion/paint.h"
#include "lib/figures/painters.h"
#include "lib/figures/patrician/paint.h"
#include "lib/figures/patrician/patrician.h"
#include "lib/figures/plebeian/plebeian.h"

namespace claque::figures
{

namespace
{

constexpr float mouth_y = 1.5636f;

// The thickness of a full beard, 0 to 1: from the whiskers along the jaw to the chin and down the throat to `lowest`,
// and on the upper lip; the cheeks above it are bare.
float beard(glm::vec3 p, float lowest)
{
    static const glm::vec2 upper[] = {{-0.012f, 1.600f}, {0.004f, 1.612f}, {0.020f, 1.606f}, {0.040f, 1.584f},
                                      {0.060f, 1.570f},  {0.080f, 1.562f}, {0.200f, 1.560f}};
    const glm::vec2 q(std::fabs(p.x), p.y);
    float thick = smoothstep(0.005f, -0.008f, p.y - profile(upper, p.z)) * smoothstep(-0.016f, 0.004f, p.z);
    thick *= smoothstep(lowest - 0.008f, lowest + 0.010f, p.y + 0.06f * p.z);
    thick *= smoothstep(0.80f, 1.06f, std::max(q.x / 0.027f, std::fabs(p.y - mouth_y) / 0.0125f));
    const float lip = spot(to_segment(q, {0.0030f, 1.5765f}, {0.0270f, 1.5700f}), 0.0074f);
    const float corner = spot(to_segment(q, {0.0285f, 1.5675f}, {0.0285f, 1.5460f}), 0.0090f);
    const float under = spot(q, {0, 1.5470f}, {0.0100f, 0.0080f});
    return std::max({thick, 1.2f * lip, 1.1f * corner, under});
}

// Curls in rows; `shade` is the luminance that the face has there.
Paint curls(glm::vec3 p, float shade)
{
    const float row = (1.62f - p.y) * 90 + 0.9f * value_noise(p.x * 90, p.z * 90, 501);
    const float down = row - std::floor(row);
    const float lock = value_noise(p.x * 210 + 0.5f * std::floor(row), p.z * 190 + std::floor(row) * 1.7f, 502);
    const float strand = value_noise(p.x * 760 + p.z * 500, p.y * 300, 503);
    return {(118 + 46 * (1 - down) + 44 * lock + 40 * strand) * shade, Zone::hair};
}

Paint bearded(const Texel &t, Paint paint, float lowest)
{
    if (t.chart != Chart::head || paint.zone != Zone::skin) return paint;
    const glm::vec3 p = t.position;
    const float thick = beard(p, lowest), ragged = value_noise(p.x * 520, p.y * 420 + p.z * 380, 504);
    if (thick > 0.30f + 0.34f * ragged) return curls(p, std::min(1.0f, paint.luminance / 214));
    paint.luminance -= 34 * thick;
    return paint;
}

bool on_face(const Texel &t) { return t.chart == Chart::head && t.position.z > 0.02f; }

// True on `count` bands at every `pitch` about `middle`, each within the half width `half`.
bool on_bands(float x, float middle, float pitch, float half, int count)
{
    const float nearest = std::floor((x - middle) / pitch + 0.5f);
    return std::fabs(nearest) <= 0.5f * static_cast<float>(count) && std::fabs(x - middle - nearest * pitch) < half;
}

}  // namespace

Paint paint_bearded_citizen(const Texel &t)
{
    Paint paint = bearded(t, paint_citizen(t), 1.502f);
    const bool trunk = t.chart == Chart::tunic_front || t.chart == Chart::tunic_back;
    const float column = std::fabs(t.chart == Chart::tunic_front ? t.st.x : t.st.x - 7);
    const bool hem = t.position.y<0.56f, neck = t.position.y> 1.42f;
    if (trunk && paint.zone == Zone::border && column > 0.94f && column < 1.31f && !hem && !neck)
        paint.zone = Zone::tunic;
    // One broad band above the hem instead.
    if (trunk && paint.zone == Zone::tunic && on_bands(t.position.y, 0.600f, 0.030f, 0.0085f, 2))
        paint.zone = Zone::border;
    return paint;
}

Paint paint_banded_patrician(const Texel &t)
{
    Paint paint = paint_patrician(t);
    const glm::vec3 p = t.position;
    if (paint.zone == Zone::outer && t.chart == patrician::palla && on_bands(t.st.y, 1.5f, 0.42f, 0.085f, 2))
        paint.zone = Zone::border;
    const bool gown = t.chart == patrician::gown_front || t.chart == patrician::gown_back;
    if (paint.zone == Zone::tunic && gown && on_bands(p.y, 0.30f, 0.055f, 0.009f, 2)) paint.zone = Zone::border;
    if (paint.zone == Zone::outer && gown && on_bands(p.y - 0.32f * p.x, 0.70f, 0.040f, 0.008f, 2))
        paint.zone = Zone::border;
    if (on_face(t) && paint.zone == Zone::skin) {  // rouge, and shade on the lids
        const glm::vec2 q(std::fabs(p.x), p.y);
        paint.luminance -= 20 * spot(q, {0.0440f, 1.6000f}, {0.020f, 0.014f});
        paint.luminance -= 34 * spot(q, {0.0315f, 1.6430f}, {0.018f, 0.0055f});
    }
    if (on_face(t) && paint.zone == Zone::hair) paint.luminance *= 0.62f;
    return paint;
}

Paint paint_bearded_decurion(const Texel &t)
{
    Paint paint = bearded(t, paint_decurion(t), 1.488f);
    if (paint.zone == Zone::outer && (t.chart == decurion::balteus || t.chart == decurion::umbo) &&
        on_bands(t.st.y, 1.5f, 1, 0.28f, 0))
        paint.zone = Zone::border;
    return paint;
}

Paint paint_shaven_plebeian(const Texel &t)
{
    Paint paint = paint_plebeian(t);
    const glm::vec3 p = t.position;
    const glm::vec2 q(std::fabs(p.x), p.y);
    if (t.chart == Chart::head && p.z > -0.012f && p.y < 1.612f && paint.zone == Zone::hair)
        paint = {206 - 16 * value_noise(p.x * 700, p.y * 520 + p.z * 400, 511), Zone::skin};
    const bool patch = std::fabs(p.x + 0.085f) < 0.045f && std::fabs(p.y - 0.800f) < 0.052f && p.z > 0;
    const bool other = std::fabs(p.x - 0.060f) < 0.034f && std::fabs(p.y - 1.190f) < 0.038f && p.z > 0;
    if (paint.zone == Zone::tunic && (patch || other)) {
        const glm::vec2 d = patch ? glm::vec2(p.x + 0.085f, p.y - 0.800f) / glm::vec2(0.045f, 0.052f)
                                  : glm::vec2(p.x - 0.060f, p.y - 1.190f) / glm::vec2(0.034f, 0.038f);
        const float edge = std::max(std::fabs(d.x), std::fabs(d.y));
        const float stitch = std::fmod(std::fabs(std::fabs(d.x) > std::fabs(d.y) ? p.y : p.x), 0.010f) < 0.005f;
        paint = {paint.luminance + 14 - (edge > 0.86f ? 70 * stitch : 0), Zone::border};
    }
    return paint;
}

}  // namespace claque::figures
