// Paints wings: rows of coverts, then the long feathers.
#include <cmath>

#include "lib/figures/brush.h"
#include "lib/figures/flyer/wing.h"

namespace claque::figures::flyer
{

namespace
{

// One row of feathers from `from` to `until` along the chord. Inside a feather: 0 .. 1 along it, -1 .. 1 across.
struct Quill {
    bool inside;
    float along, across, shade;
};

Quill quill_at(float u, float c, float from, float until, float count)
{
    const float k = u * count, number = std::floor(k), across = 2 * (k - number) - 1;
    const float rounded = until - 0.22f * (until - from) * across * across;
    return {c < rounded, (c - from) / (until - from), across, value_noise(number * 3.7f, from * 50, 21)};
}

float feather(const Quill &q)
{
    float g = 232 + 20 * (q.shade - 0.5f);
    g += 10 * q.across;                               // each overlaps the next
    g -= 34 * spot(q.across, 0.10f) * (1 - q.along);  // shaft
    g -= 46 * smoothstep(0.80f, 1.0f, std::fabs(q.across));
    g -= 30 * smoothstep(0.72f, 1.0f, q.along);
    g -= 7 * value_noise(q.along * 26 + 8 * std::fabs(q.across), q.shade * 90, 22);
    return g;
}

}  // namespace

Paint paint_wing(const Texel &t, const Plumage &plumage)
{
    const float c = -t.st.x, u = t.st.y;
    struct Layer {
        float from, until, count;
    };
    // The rows nearest to the leading edge are on top.
    static constexpr Layer layers[] = {{0.00f, 0.13f, 26}, {0.08f, 0.24f, 21}, {0.18f, 0.40f, 17}};
    for (const Layer &layer : layers) {
        const Quill q = quill_at(u, c, layer.from, layer.until, layer.count);
        if (!q.inside) continue;
        return {feather(q), layer.until < 0.2f ? plumage.shoulder : plumage.feathers};
    }
    Quill q = quill_at(u - 0.004f, c, 0.36f, 2, 11);
    q.along = (c - 0.36f) / 0.64f;
    float g = feather(q) - 14 * smoothstep(0.36f, 0.44f, c) * spot(c - 0.40f, 0.05f);
    for (int i = 0; i < plumage.bands; ++i) {
        const float from = 0.74f - 0.17f * static_cast<float>(i), bent = c - 0.03f * q.across * q.across;
        g -= (i == 0 ? 70 : 44) * smoothstep(from, from + 0.05f, bent) *
             (i == 0 ? 1 : smoothstep(from + 0.12f, from + 0.08f, bent));
    }
    return {g, plumage.feathers};
}

}  // namespace claque::figures::flyer
