// A bank of ring curls over the brow; behind it, strands combed back to a bun of coiled braids.
#include <glm/vec3.hpp>

#include "lib/figures/brush.h"
#include "lib/figures/patrician/paint.h"
#include "lib/figures/patrician/patrician.h"
#include "lib/math/trig.h"

namespace claque::figures::patrician
{

float hair_edge(glm::vec3 p)
{
    // Beside the face and behind it, by depth: temple, in front of the ear, behind it, nape.
    static const glm::vec2 sides[] = {{-0.085f, 1.570f}, {-0.060f, 1.574f}, {-0.036f, 1.590f}, {-0.028f, 1.620f},
                                      {-0.006f, 1.630f}, {0.014f, 1.620f},  {0.024f, 1.624f},  {0.036f, 1.644f},
                                      {0.050f, 1.662f},  {0.070f, 1.675f},  {0.095f, 1.690f},  {0.106f, 1.696f}};
    const float jag = value_noise(p.x * 190 + 40, p.z * 150, 101) - 0.5f;
    // Ringlets overlap the edge over the brow.
    const float lap = std::fabs(p.x) * 68 + 0.5f - std::floor(std::fabs(p.x) * 68 + 0.5f) - 0.5f;
    const float scallop = 0.0055f * (1 - 4 * lap * lap) * smoothstep(0.050f, 0.075f, p.z);
    return profile(sides, p.z) + 0.002f - scallop + 0.003f * jag;
}

namespace
{

// Ringlets side by side in rows that are offset like tiles, each different from its neighbours.
float curls(float u, float v)
{
    const float row = std::floor(v + 0.3f * value_noise(u * 0.9f, v * 0.5f, 108));
    const float across = u + 0.5f * (row - 2 * std::floor(row / 2)) + 0.3f * value_noise(row * 1.3f, u * 0.5f, 102);
    const float cell = std::floor(across), own = value_noise(cell * 3.1f, row * 2.7f, 109),
                other = value_noise(cell * 2.3f, row * 4.1f, 110);
    const float x = across - cell - 0.42f - 0.16f * own, y = v - row - 0.42f - 0.16f * other;
    const float r = std::sqrt(x * x + y * y), size = 0.24f + 0.10f * other;
    const float lit = 0.55f + 0.45f * (y * 1.6f - x * 0.6f);  // light from above
    const float strand = value_noise(across * 5 + y * 9, v * 6 - x * 9, 103);
    return 192 + 26 * (own - 0.5f) + 74 * spot(r - size, 0.24f) * lit - 44 * spot(r, 0.15f) -
           40 * smoothstep(0.40f, 0.62f, r) + 40 * (strand - 0.5f);
}

// 0 at the bank of curls, growing towards the back.
float behind(glm::vec3 p) { return 0.016f - 0.20f * std::max(0.0f, 1.70f - p.y) - p.z; }

}  // namespace

Paint paint_hair(const Texel &t)
{
    const glm::vec3 p = t.position;
    const float back = behind(p);
    const float edge = smoothstep(0, 0.010f, p.y - hair_edge(p));
    if (back < 0 && t.chart == Chart::head) {
        const float round = p.x / (std::fabs(p.x) + std::max(p.z + 0.01f, 0.0f) + 0.01f);
        const float up = p.y + 0.6f * std::max(0.0f, 0.09f - p.z);
        // The crest is light, roots and temples are dark.
        const float crest = 30 * spot(p.y - 1.755f, 0.055f) - 26 * smoothstep(1.735f, 1.690f, p.y);
        return {curls(round * 6.5f, up * 46) + crest - 24 * (1 - edge), Zone::hair};
    }
    // Strands run to the bun.
    const float dx = p.x, dy = p.y - 1.712f;
    const float turn = dy >= std::fabs(dx) ? dx / (dy + 1e-4f)
                       : dx > 0            ? 2 - dy / (dx + 1e-4f)
                                           : -2 - dy / (-dx + 1e-4f);
    const float wave = 0.12f * math::sin(p.z * 160);
    const float strand = value_noise((turn + wave) * 22, p.z * 16, 104);
    const float lock = value_noise((turn + wave) * 7, p.z * 10, 105);
    return {178 + 50 * strand + 44 * lock - 22 * (1 - edge) - 70 * spot(back, 0.012f), Zone::hair};
}

Paint paint_bun(const Texel &t)
{
    const float r = std::sqrt(t.st.x * t.st.x + t.st.y * t.st.y);
    // The distance along the coil; the angle is computed by divisions.
    const float x = t.st.x, y = t.st.y;
    const float part = std::fabs(x) + std::fabs(y) > 1e-5f ? x / (std::fabs(x) + std::fabs(y)) : 0;
    const float angle = y >= 0 ? part : 2 - part;  // -1 .. 3
    const float coil = r * 3.2f + angle * 0.25f;
    const float across = coil - std::floor(coil);
    const float along = angle * (4 + 4 * std::floor(coil));
    const float plait = std::fabs(std::fmod(std::fabs(along + (across > 0.5f ? across : 1 - across) * 2), 1.0f) - 0.5f);
    const float round = 1 - 4 * (across - 0.5f) * (across - 0.5f);
    return {136 + 84 * round + 50 * plait + 24 * (value_noise(angle * 40, r * 40, 106) - 0.5f), Zone::hair};
}

}  // namespace claque::figures::patrician
