// A bank of ring curls over the brow, a gold band behind it, strands drawn back to a bun of coiled braids.
#include <glm/vec3.hpp>

#include "lib/figures/brush.h"
#include "lib/figures/patrician/paint.h"
#include "lib/figures/patrician/patrician.h"

namespace claque::figures::patrician
{

float hair_edge(glm::vec3 p)
{
    // Beside the face and behind by depth: temple, before the ear, behind it, nape.
    static const glm::vec2 sides[] = {{-0.085f, 1.570f}, {-0.060f, 1.574f}, {-0.036f, 1.590f}, {-0.028f, 1.634f},
                                      {-0.006f, 1.640f}, {0.014f, 1.628f},  {0.024f, 1.632f},  {0.036f, 1.654f},
                                      {0.052f, 1.684f},  {0.070f, 1.697f},  {0.100f, 1.702f}};
    const float jag = grain(p.x * 190 + 40, p.z * 150, 101) - 0.5f;
    return profile(sides, p.z) + 0.004f * jag;
}

namespace
{

// Little rings side by side in rows that are offset like tiles.
float curls(float u, float v)
{
    const float row = std::floor(v);
    const float across = u + 0.5f * (row - 2 * std::floor(row / 2)) + 0.2f * grain(row * 1.3f, u * 0.5f, 102);
    const float x = across - std::floor(across) - 0.5f, y = v - row - 0.5f;
    const float r = std::sqrt(x * x + y * y);
    const float lit = 0.5f + 0.5f * (y * 1.2f - x * 0.6f);  // light from above
    return 132 + 104 * spot(r - 0.30f, 0.22f) * (0.55f + 0.6f * lit) - 56 * spot(r, 0.17f) -
           46 * soft_step(0.42f, 0.58f, r) + 22 * (grain(across * 7, v * 7, 103) - 0.5f);
}

// Behind the bank of curls: 0 there, growing towards the back.
float behind(glm::vec3 p) { return 0.016f - 0.20f * std::max(0.0f, 1.70f - p.y) - p.z; }

}  // namespace

Paint paint_hair(const Texel &t)
{
    const glm::vec3 p = t.position;
    const float back = behind(p);
    const float edge = soft_step(0, 0.010f, p.y - hair_edge(p));
    if (back < 0 && t.chart == Chart::head) {
        const float round = p.x / (std::fabs(p.x) + std::max(p.z + 0.01f, 0.0f) + 0.01f);
        const float up = p.y + 0.6f * std::max(0.0f, 0.09f - p.z);
        return {curls(round * 9, up * 62) - 24 * (1 - edge), Zone::hair};
    }
    if (back < 0.011f && p.y > 1.700f)
        return {214 + 40 * spot(back - 0.005f, 0.004f) - 60 * spot(back, 0.002f) - 60 * spot(back - 0.011f, 0.002f),
                Zone::jewellery};
    // Strands run to the bun.
    const float dx = p.x, dy = p.y - 1.712f;
    const float turn = dy >= std::fabs(dx) ? dx / (dy + 1e-4f)
                       : dx > 0            ? 2 - dy / (dx + 1e-4f)
                                           : -2 - dy / (-dx + 1e-4f);
    const float wave = 0.12f * std::sin(p.z * 160);
    const float strand = grain((turn + wave) * 22, p.z * 16, 104);
    const float lock = grain((turn + wave) * 7, p.z * 10, 105);
    return {148 + 58 * strand + 40 * lock - 22 * (1 - edge) - 30 * spot(back - 0.013f, 0.010f), Zone::hair};
}

Paint paint_bun(const Texel &t)
{
    const float r = std::sqrt(t.st.x * t.st.x + t.st.y * t.st.y);
    // Distance along the coil, as the angle by divisions.
    const float x = t.st.x, y = t.st.y;
    const float part = std::fabs(x) + std::fabs(y) > 1e-5f ? x / (std::fabs(x) + std::fabs(y)) : 0;
    const float angle = y >= 0 ? part : 2 - part;  // -1 .. 3
    const float coil = r * 3.2f + angle * 0.25f;
    const float across = coil - std::floor(coil);
    const float along = angle * (4 + 4 * std::floor(coil));
    const float plait = std::fabs(std::fmod(std::fabs(along + (across > 0.5f ? across : 1 - across) * 2), 1.0f) - 0.5f);
    const float round = 1 - 4 * (across - 0.5f) * (across - 0.5f);
    return {96 + 92 * round + 50 * plait + 24 * (grain(angle * 40, r * 40, 106) - 0.5f), Zone::hair};
}

}  // namespace claque::figures::patrician
