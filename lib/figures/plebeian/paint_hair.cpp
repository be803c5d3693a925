// Tousled hair: overlapping locks of uneven length.
#include <glm/vec3.hpp>

#include "lib/figures/brush.h"
#include "lib/figures/plebeian/plebeian.h"

namespace claque::figures::plebeian
{

float hair_edge(glm::vec3 p)
{
    // Nape, behind the ear, over its rim, temple, and the fringe over the brow.
    static const glm::vec2 line[] = {{-0.110f, 1.520f}, {-0.070f, 1.528f}, {-0.040f, 1.560f}, {-0.030f, 1.618f},
                                     {-0.012f, 1.640f}, {0.006f, 1.636f},  {0.014f, 1.604f},  {0.028f, 1.606f},
                                     {0.040f, 1.648f},  {0.056f, 1.684f},  {0.076f, 1.693f},  {0.110f, 1.686f}};
    const float strand = value_noise(p.x * 210 + 40, p.z * 150, 201) - 0.5f;
    const float lock = value_noise(p.x * 64 + 11, p.z * 40, 202) - 0.5f;
    const float free = smoothstep(0.035f, 0.065f, p.z);
    return profile(line, p.z) + strand * (0.006f + 0.006f * free) + lock * (0.008f + 0.026f * free);
}

Paint paint_hair(const Texel &t)
{
    const glm::vec3 p = t.position;
    const float dx = p.x - 0.012f, dz = p.z + 0.022f;  // the whorl is off the middle
    const float round = dx / (std::fabs(dx) + std::fabs(dz) + 0.004f);
    const float far = std::sqrt(dx * dx + dz * dz) + 0.9f * (1.775f - p.y);
    const float v = far * 24 + 1.5f * value_noise(round * 4 + 9, far * 7, 203);
    const float row = std::floor(v), down = v - row;
    const float bend = 0.8f * down * down * (value_noise(row * 1.7f, round * 3 + 5, 204) - 0.5f) * 2;
    const float u =
        (dz < 0 ? 40 + round : round) * 6.5f + 0.5f * row + bend + 0.8f * value_noise(row * 3.1f, round * 3, 205);
    const float across = u - std::floor(u);
    const float shade = value_noise(std::floor(u) * 1.7f, row * 2.3f, 206);
    const float strand = value_noise(u * 7, v * 0.9f, 207), fine = value_noise(u * 16, v * 1.4f, 208);
    const float lock = 1 - 4 * (across - 0.5f) * (across - 0.5f);
    const float edge = smoothstep(0, 0.014f, p.y - hair_edge(p));
    return {104 + 56 * lock + 30 * (1 - down) + 34 * (shade - 0.5f) + 40 * strand + 26 * fine - 24 * (1 - edge),
            Zone::hair};
}

}  // namespace claque::figures::plebeian
