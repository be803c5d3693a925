// A foot in its sandal: contours seen from above, from the ankle to the edge of the sole.
#include "lib/figures/parts.h"
#include "lib/figures/skeleton.h"

namespace claque::figures
{

namespace
{

using Contour = std::array<glm::vec3, 8>;

// From the heel over the inner side and the toes to the outer side, left foot, about the ankle in x.
const std::array<Contour, 3> contours = {{
    {{{0, 0.058f, -0.066f},
      {-0.027f, 0.052f, -0.050f},
      {-0.035f, 0.056f, 0.005f},
      {-0.028f, 0.062f, 0.066f},
      {0.000f, 0.068f, 0.066f},
      {0.026f, 0.056f, 0.058f},
      {0.035f, 0.046f, 0.000f},
      {0.027f, 0.048f, -0.050f}}},
    {{{0, 0.018f, -0.074f},  // the upper edge of the sole
      {-0.030f, 0.017f, -0.058f},
      {-0.034f, 0.020f, 0.035f},
      {-0.040f, 0.028f, 0.146f},
      {-0.016f, 0.026f, 0.190f},
      {0.022f, 0.024f, 0.176f},
      {0.047f, 0.018f, 0.090f},
      {0.032f, 0.016f, -0.055f}}},
    {{{0, 0, -0.080f},
      {-0.034f, 0, -0.062f},
      {-0.037f, 0, 0.035f},
      {-0.045f, 0, 0.150f},
      {-0.018f, 0, 0.201f},
      {0.026f, 0, 0.187f},
      {0.052f, 0, 0.092f},
      {0.036f, 0, -0.059f}}},
}};

}  // namespace

void add_foot(Mesh &mesh, Side side, const std::vector<uint32_t> &ankle)
{
    const float x0 = skeleton().joint(Bone::foot).x;
    const float turn = 0.10f;  // toes outwards, as a slope
    const Chart chart = on(side, Chart::foot);
    // As seen from above. Steep rings are spread outwards so that none overlaps another.
    const auto chain_of = [&](const std::vector<uint32_t> &ring, float spread) {
        Chain chain;
        for (size_t i = 0; i <= ring.size(); ++i) {
            const glm::vec3 p = mirrored(mesh.points[ring[i % ring.size()]].position, side);
            chain.push_back({ring[i % ring.size()], glm::vec2(p.x - x0 - turn * p.z, p.z) * spread});
        }
        return chain;
    };
    Chain above = chain_of(ankle, 0.6f);
    const std::array<float, 3> spreads = {1.0f, 1.25f, 1.40f};
    std::vector<uint32_t> ring;
    for (size_t c = 0; c < contours.size(); ++c) {
        ring.clear();
        for (const glm::vec3 p : contours[c])
            ring.push_back(mesh.add(mirrored(glm::vec3(x0 + p.x + turn * p.z, p.y, p.z), side), Region::foot, side));
        const Chain next = chain_of(ring, spreads[c]);
        for (size_t i = 0; i + 1 < next.size(); ++i)
            mesh.sew(chart, winding_of(side), {next[i], next[i + 1]}, {above[i], above[i + 1]}, Along::s);
        above = next;
    }
    Chain loop = chain_of(ring, 1);
    loop.pop_back();
    // Heel and toes first, so that the sole's triangles run across it.
    Chain turned(loop.begin() + 4, loop.end());
    turned.insert(turned.end(), loop.begin(), loop.begin() + 4);
    mesh.cap(on(side, Chart::sole), side == Side::left ? Winding::reversed : Winding::as_given, turned);
}

}  // namespace claque::figures
