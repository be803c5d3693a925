// The palla: a heavy mantle whose folds run round the hips and up over the left shoulder, with a woven border.
#include <glm/vec3.hpp>

#include "lib/figures/brush.h"
#include "lib/figures/patrician/paint.h"
#include "lib/figures/patrician/patrician.h"

namespace claque::figures::patrician
{

namespace
{

float lower_edge(glm::vec3 p) { return 0.610f + 0.32f * p.x; }
float upper_edge(glm::vec3 p) { return 1.070f + 0.030f * p.x; }

// Above the waist: behind, below the line from the right hip to the left shoulder; in front, towards the left arm.
bool thrown_over(glm::vec3 p)
{
    if (p.z > -0.005f) return p.x > 0.100f;
    const glm::vec2 hip(-0.172f, 1.055f), shoulder(0.095f, 1.450f), to = shoulder - hip;
    return to.x * (p.y - hip.y) - to.y * (p.x - hip.x) < 0;
}

}  // namespace

bool is_mantle(const Texel &t)
{
    const glm::vec3 p = t.position;
    if (t.chart == gown_front || t.chart == gown_back) return p.y > lower_edge(p) - 0.002f;
    if (t.chart == bodice_front || t.chart == bodice_back) return p.y < upper_edge(p) + 0.004f || thrown_over(p);
    return t.chart == Chart::sleeve || t.chart == palla;
}

Paint paint_mantle(const Texel &t)
{
    const glm::vec3 p = t.position;
    // Folds hang in bows from the left shoulder to the right hip, flatter towards the hem.
    static const glm::vec2 slopes[] = {{0.55f, 0.30f}, {0.80f, 0.40f}, {1.05f, 0.80f}, {1.30f, 1.40f}};
    const float sag = 1.1f * (p.x + 0.02f) * (p.x + 0.02f);
    const float line = p.y - profile(slopes, p.y) * p.x - sag + 0.03f * value_noise(p.x * 9 + p.z * 7, p.y * 6, 121);
    const float across = p.x * 4 + p.z * 3 + 9;
    float g = 222 + 34 * crease(value_noise(line * 13, across, 122)) +
              16 * crease(value_noise(line * 36, across * 1.7f, 123));
    const float low = p.y - lower_edge(p);
    if (t.chart != gown_front && t.chart != gown_back) return {g, Zone::outer};
    if (low < 0.022f) return {g + 8 - 40 * spot(low - 0.022f, 0.004f), Zone::border};
    return {g, Zone::outer};
}

Paint paint_palla(const Texel &t)
{
    // Folds run along the band.
    const float along = t.st.x, across = t.st.y;
    const float wander = 0.5f * (value_noise(along * 5, across, 124) - 0.5f);
    float g = 224 + 34 * crease(value_noise(along * 2.2f, (across + wander) * 2.6f, 125)) +
              18 * crease(value_noise(along * 4, (across + wander) * 6.5f, 126));
    g -= 26 * spot(across, 0.25f) + 26 * spot(across - 3, 0.25f);
    if (across < 0.34f) return {g + 14, Zone::border};
    return {g, Zone::outer};
}

}  // namespace claque::figures::patrician
