// The palla: a heavy mantle whose folds run round the hips and up over the left shoulder, with a woven border.
#include <glm/vec3.hpp>

#include "lib/figures/brush.h"
#include "lib/figures/patrician/paint.h"
#include "lib/figures/patrician/patrician.h"

namespace claque::figures::patrician
{

namespace
{

float lower_edge(glm::vec3 p) { return 0.715f + 0.075f * p.x / 0.2f * 0.2f; }
float upper_edge(glm::vec3 p) { return 1.070f + 0.030f * p.x; }

}  // namespace

bool on_gown_palla(const Texel &t)
{
    if (t.chart != gown_front && t.chart != gown_back && t.chart != bodice_front && t.chart != bodice_back)
        return false;
    const glm::vec3 p = t.position;
    return p.y > lower_edge(p) - 0.002f && p.y < upper_edge(p) + 0.004f;
}

Paint paint_gown_palla(const Texel &t)
{
    const glm::vec3 p = t.position;
    const float a = around_body(p), low = p.y - lower_edge(p);
    // Swags: folds hang in bows between the hips, lower on the right.
    const float bow = (p.z > 0 ? 0.045f : 0.030f) * std::min(a * a, 4.0f);
    const float line = p.y - bow - 0.10f * p.x + 0.02f * grain(a * 3, p.y * 6, 121);
    float g = 222 + 30 * crease(grain(line * 15, a * 0.7f + 9, 122)) + 14 * crease(grain(line * 38, a * 1.6f + 9, 123));
    g -= 30 * spot(upper_edge(p) - p.y, 0.012f);
    if (low < 0.030f) return {g + 8 - 40 * spot(low - 0.030f, 0.005f), Zone::border};
    return {g, Zone::outer};
}

Paint paint_palla(const Texel &t)
{
    // Folds run along the band.
    const float along = t.st.x, across = t.st.y;
    const float wander = 0.5f * (grain(along * 5, across, 124) - 0.5f);
    float g = 224 + 34 * crease(grain(along * 2.2f, (across + wander) * 2.6f, 125)) +
              18 * crease(grain(along * 4, (across + wander) * 6.5f, 126));
    g -= 26 * spot(across, 0.25f) + 26 * spot(across - 3, 0.25f);
    if (across > 2.72f) return {g + 8 - 30 * spot(across - 2.72f, 0.05f), Zone::border};
    return {g, Zone::outer};
}

}  // namespace claque::figures::patrician
