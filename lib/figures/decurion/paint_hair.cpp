// The remaining hair: short locks at temples and nape, combed forward over a high forehead, thin on the crown.
#include <glm/vec3.hpp>

#include "lib/figures/brush.h"
#include "lib/figures/decurion/paint.h"

namespace claque::figures::decurion
{

float hair_edge(glm::vec3 p)
{
    static const glm::vec2 line[] = {{-0.085f, 1.550f}, {-0.060f, 1.556f}, {-0.036f, 1.576f}, {-0.030f, 1.636f},
                                     {-0.012f, 1.655f}, {0.008f, 1.650f},  {0.012f, 1.618f},  {0.022f, 1.616f},
                                     {0.032f, 1.668f},  {0.044f, 1.712f},  {0.056f, 1.738f},  {0.080f, 1.760f}};
    // A tuft remains in the middle of the forehead.
    const float tuft = 0.016f * spot(p.x, 0.026f) * smoothstep(0.03f, 0.05f, p.z);
    const float jag = value_noise(p.x * 170 + 40, p.z * 130, 321) - 0.5f;
    return profile(line, p.z) - tuft + jag * (p.z > 0.03f ? 0.016f : 0.008f);
}

Paint paint_aged_hair(const Texel &t)
{
    const glm::vec3 p = t.position;
    const float dx = p.x, dz = p.z + 0.035f;
    const float round = dx / (std::fabs(dx) + std::fabs(dz) + 0.004f);
    const float far = std::sqrt(dx * dx + dz * dz) + 0.9f * (1.75f - p.y);
    const float v = far * 40 + 0.9f * value_noise(round * 5 + 9, far * 9, 322);
    const float row = std::floor(v), down = v - row;
    const float bend = 0.40f * down * down * (value_noise(row * 0.7f, round * 2 + 5, 325) > 0.5f ? 1.0f : -1.0f);
    const float u = (dz < 0 ? 40 + round : round) * 9 + 0.5f * row + bend;
    const float across = u - std::floor(u);
    const float strand = value_noise(u * 7, v * 0.9f, 324), shade = value_noise(std::floor(u) * 1.7f, row * 2.3f, 323);
    const float lock = 1 - 4 * (across - 0.5f) * (across - 0.5f);
    // Thin on top: the scalp shows between the strands.
    const float top = smoothstep(1.700f, 1.735f, p.y) * smoothstep(-0.085f, -0.045f, p.z);
    if (top * (0.55f + 0.9f * (1 - lock) * down + 0.4f * strand) > 0.80f) return {212 + 14 * strand, Zone::skin};
    const float edge = smoothstep(0, 0.014f, p.y - hair_edge(p));
    return {138 + 46 * lock + 26 * (1 - down) + 30 * (shade - 0.5f) + 44 * strand - 20 * (1 - edge), Zone::hair};
}

}  // namespace claque::figures::decurion
