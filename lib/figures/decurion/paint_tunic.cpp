// The visible parts of tunic and shoes: breast and right sleeve with the broad stripe, and closed boots tied with
// thongs.
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include "lib/figures/brush.h"
#include "lib/figures/decurion/decurion.h"
#include "lib/figures/decurion/paint.h"
#include "lib/figures/skeleton.h"

namespace claque::figures::decurion
{

namespace
{

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
    for (size_t i = 0; i + 1 < neckline.size(); ++i)
        least = std::min(least, to_segment(p, neckline[i], neckline[i + 1]));
    return least;
}

Paint sleeve(glm::vec3 p)
{
    const glm::vec3 from = mirrored(p, Side::right) - skeleton().joint(Bone::upper_arm);
    const float along = glm::dot(from, arm_direction()), up = glm::dot(from, arm_dorsal());
    const float round = up * 12 + from.z * 16;
    const float g =
        222 + 28 * crease(value_noise(round * 2.4f + along * 2, along * 3, 351)) - 22 * spot(up + 0.07f, 0.04f);
    if (along > 0.222f) return {g - 36 * spot(along - 0.222f, 0.004f), Zone::border};
    return {g, Zone::tunic};
}

}  // namespace

Paint paint_tunic(const Texel &t)
{
    const glm::vec3 p = t.position;
    if (t.chart == Chart::sleeve_inside_r) return {112, Zone::tunic};
    if (t.chart == Chart::sleeve_r) return sleeve(p);
    const float sag = std::fabs(p.x);
    const float swing = p.y + (p.z > 0 ? -2.6f : -1.4f) * sag * sag + 0.016f * value_noise(p.x * 26 + 30, p.y * 9, 352);
    float g = 222 + 20 * crease(value_noise(swing * 16, 3.0f + sag * 3, 353)) +
              16 * crease(value_noise(swing * 36, 5.0f + sag * 5, 354));
    const float neck = to_neckline(p);
    if (neck < 0.012f) return {g - 40 * spot(neck, 0.004f), Zone::border};
    // The broad stripe runs along the weave: by the column of the cloth.
    const float column = t.chart == chest_front ? t.st.x + 1 : t.st.x - 7;
    const float stripe = std::fabs(column) - 0.28f;
    if (stripe < 0) return {g - 30 * spot(stripe, 0.05f), Zone::border};
    return {g - 24 * spot(neck - 0.014f, 0.006f), Zone::tunic};
}

Paint paint_shoe(const Texel &t)
{
    const glm::vec3 p = mirrored(t.position, t.side);
    if (t.chart == Chart::sole || t.chart == Chart::sole_r) return {110, Zone::sandals};
    const float x = p.x - 0.092f - 0.10f * p.z;
    float g = 214 + 26 * (value_noise(p.x * 160, p.z * 160 + p.y * 120, 361) - 0.5f);
    if (p.y < 0.014f) return {120 + 16 * value_noise(x * 200, p.z * 200, 362), Zone::sandals};
    g -= 50 * spot(p.y - 0.0155f, 0.005f);  // welt
    // Thongs: crossed over the instep, wound twice round the ankle, tied in front.
    const auto thong = [&g](float from_edge) {
        if (from_edge < 0.0045f) g = 246 - 26 * spot(from_edge, 0.002f);
        else g -= 46 * spot(from_edge - 0.0060f, 0.0025f);
    };
    if (p.y > 0.072f) thong(std::fabs(p.y - 0.098f - 0.02f * p.z));
    else if (p.z > 0.02f) thong(std::min(std::fabs(p.z - 0.066f - 0.55f * x), std::fabs(p.z - 0.066f + 0.55f * x)));
    const float knot = std::sqrt(x * x + (p.y - 0.100f) * (p.y - 0.100f));
    if (p.z > 0 && knot < 0.010f) g = 250 - 60 * spot(knot - 0.009f, 0.002f);
    g -= 26 * spot(p.z - 0.138f - 0.3f * x, 0.007f) * (p.y < 0.06f ? 1.0f : 0.0f);  // where the toes bend
    return {g, Zone::sandals};
}

}  // namespace claque::figures::decurion
