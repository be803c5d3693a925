// The toga: heavy cloth whose folds hang in bows from the left shoulder to the right hip and fall straight below. Its
// curved edge carries a woven border.
#include <glm/vec3.hpp>

#include "lib/figures/brush.h"
#include "lib/figures/decurion/decurion.h"
#include "lib/figures/decurion/paint.h"

namespace claque::figures::decurion
{

namespace
{

constexpr float hem = 0.115f, hem_border = 0.030f, sinus_border = 0.040f;
constexpr float edge_t = 0.660f;  // t of the chart at the row of the sinus's edge

bool round_legs(const Texel &t) { return t.chart == toga_front || t.chart == toga_back; }

// Above the waist the toga is the cloth below the roll; it ends under the middle of the roll.
bool thrown_over(const Texel &t)
{
    static const glm::vec2 front[] = {{-0.20f, 1.120f}, {-0.145f, 1.150f}, {0, 1.215f},
                                      {0.084f, 1.295f}, {0.109f, 1.386f},  {0.130f, 1.550f}};
    static const glm::vec2 back[] = {{-0.20f, 1.120f}, {-0.154f, 1.155f}, {-0.054f, 1.200f},
                                     {0.035f, 1.294f}, {0.100f, 1.405f},  {0.130f, 1.550f}};
    const glm::vec3 p = t.position;
    return p.y < (t.chart == chest_front ? profile(front, p.x) : profile(back, p.x));
}

// The edge of the sinus at a fractional column: its height and its distance from the cloth below.
SinusEdge edge_at(const Texel &t)
{
    const float k = t.st.x + columns;
    const size_t low = static_cast<size_t>(k) % columns, high = (low + 1) % columns;
    const float f = k - std::floor(k);
    return {sinus[low].y + (sinus[high].y - sinus[low].y) * f, sinus[low].out + (sinus[high].out - sinus[low].out) * f};
}

// Straight folds of the part down to the shins, broader towards the hem.
float fall(const Texel &t)
{
    const glm::vec3 p = t.position;
    const float a = t.st.x + 0.5f * (value_noise(t.st.x * 2 + 9, p.y * 4, 331) - 0.5f);
    const float slant = p.z > 0 ? 0.9f * (p.y - hem) * (p.x + 0.05f) : 0.0f;  // pulled to the left shoulder
    const float broad = value_noise((a - 3 * slant) * 1.5f + 40, p.y * 1.2f, 332),
                fine = value_noise((a - 3 * slant) * 4 + 90, p.y * 1.8f, 333);
    return 226 + 46 * crease(broad) + 26 * crease(fine);
}

// Bows: level at the deepest point, steeper towards the left shoulder.
float bows(glm::vec3 p)
{
    if (p.z > 0) {
        const float x = p.x + 0.10f;
        const float sag = x > 0 ? 1.9f * x * x + 0.55f * x : 2.6f * x * x;
        const float line = p.y - sag + 0.030f * value_noise(p.x * 9 + 30, p.y * 7, 334);
        const float across = p.x * 3 + 9;
        return 226 + 48 * crease(value_noise(line * 15, across, 335)) +
               26 * crease(value_noise(line * 40, across * 1.7f, 336));
    }
    const float line = p.y - 0.75f * p.x - 1.2f * p.x * p.x + 0.030f * value_noise(p.x * 9 + 60, p.y * 6, 337);
    const float across = p.x * 3 + 19;
    return 226 + 44 * crease(value_noise(line * 11, across, 338)) +
           24 * crease(value_noise(line * 30, across * 1.7f, 339));
}

// The front changes from bows to straight folds at the sinus's edge, the back gradually.
float draped(const Texel &t)
{
    const glm::vec3 p = t.position;
    // Folds of front and back meet at the sides, where they are shallow.
    const float depth = p.y < 0.7f ? 1.0f : 0.2f + 0.8f * smoothstep(0.01f, 0.08f, std::fabs(p.z));
    float g = t.chart == toga_front && t.st.y < edge_t ? fall(t) : bows(p);
    if (t.chart == toga_back) g += (fall(t) - g) * smoothstep(1.02f, 0.55f, p.y);
    return 226 + (g - 226) * depth;
}

}  // namespace

bool is_toga(const Texel &t)
{
    if (round_legs(t)) return true;
    if (t.chart == chest_front || t.chart == chest_back) return thrown_over(t);
    return t.chart == Chart::sleeve || t.chart == toga_inside || t.chart == Chart::sleeve_inside;
}

Paint paint_toga(const Texel &t)
{
    const glm::vec3 p = t.position;
    if (t.chart == toga_inside || t.chart == Chart::sleeve_inside) return {112, Zone::outer};
    if (t.chart == Chart::sleeve) {
        const float round = (p.y - p.x) * 8 + p.z * 15;
        return {224 + 32 * crease(value_noise(round * 1.6f + 30, p.x * 5, 340)) +
                    16 * crease(value_noise(round * 4 + 30, p.x * 7, 341)),
                Zone::outer};
    }
    if (!round_legs(t)) return {draped(t), Zone::outer};
    const SinusEdge edge = edge_at(t);
    const float shown = smoothstep(0.002f, 0.014f, edge.out);  // of the sinus's edge
    const float up = p.y - edge.y;
    if (t.st.y >= edge_t - 0.0005f) {
        const float g = draped(t);
        const float border = sinus_border * smoothstep(0.004f, 0.022f, edge.out);
        if (border > 0.003f && up < border) return {g + 6 - 44 * spot(up - border, 0.004f), Zone::border};
        return {g + 14 * spot(up - 0.06f, 0.05f) * shown, Zone::outer};
    }
    float g = draped(t) - 74 * shown * spot(std::min(0.0f, up), 0.090f);
    if (p.y < hem + hem_border) return {g + 6 - 40 * spot(p.y - hem - hem_border, 0.004f), Zone::border};
    return {g, Zone::outer};
}

Paint paint_balteus(const Texel &t)
{
    if (t.chart == umbo) {
        // It falls in slanted folds that fade out below.
        const glm::vec3 p = t.position;
        const float across = t.st.x + 0.35f * (value_noise(t.st.x * 2 + 20, p.y * 7, 345) - 0.5f);
        const float low = smoothstep(0.95f, 0.82f, p.y);
        const float g = 44 * crease(value_noise(across * 2.6f + 40, p.y * 3, 346)) +
                        24 * crease(value_noise(across * 6 + 30, p.y * 4, 347));
        return {226 + g * (1 - 0.6f * low) - 12 * low, Zone::outer};
    }
    // Folds run along the roll, which is twisted a little.
    const float along = t.st.x, across = t.st.y;
    const float wander = 0.6f * (value_noise(along * 5, across, 342) - 0.5f) + 0.5f * along;
    float g = 222 + 40 * crease(value_noise(along * 2.2f, (across + wander) * 2.4f + 20, 343)) +
              20 * crease(value_noise(along * 4, (across + wander) * 6 + 20, 344));
    g -= 30 * spot(across, 0.30f) + 30 * spot(across - 3, 0.30f);
    if (across < 0.42f) return {g + 16, Zone::border};
    return {g, Zone::outer};
}

}  // namespace claque::figures::decurion
