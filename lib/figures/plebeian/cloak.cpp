// The short cloak, folded to a thick band over the left shoulder with its ends under the rope. Its edges lie inside the
// tunic, so it has no inner side.
#include <glm/geometric.hpp>

#include "lib/figures/plebeian/plebeian.h"

namespace claque::figures::plebeian
{

namespace
{

// The edge towards the neck, two ridges, the edge towards the arm.
using Station = std::array<glm::vec3, 4>;

const std::array<Station, 8> stations = {{
    {{{0.026f, 1.040f, 0.086f}, {0.050f, 1.040f, 0.094f}, {0.088f, 1.040f, 0.082f}, {0.108f, 1.040f, 0.050f}}},
    {{{0.026f, 1.110f, 0.104f}, {0.046f, 1.106f, 0.144f}, {0.094f, 1.104f, 0.132f}, {0.124f, 1.106f, 0.062f}}},
    {{{0.050f, 1.350f, 0.104f}, {0.066f, 1.346f, 0.140f}, {0.120f, 1.336f, 0.122f}, {0.150f, 1.322f, 0.052f}}},
    {{{0.066f, 1.430f, 0.060f}, {0.084f, 1.446f, 0.092f}, {0.134f, 1.428f, 0.088f}, {0.166f, 1.394f, 0.048f}}},
    {{{0.080f, 1.456f, -0.020f}, {0.100f, 1.494f, -0.016f}, {0.150f, 1.486f, -0.018f}, {0.190f, 1.436f, -0.014f}}},
    {{{0.058f, 1.424f, -0.092f}, {0.080f, 1.424f, -0.128f}, {0.132f, 1.404f, -0.122f}, {0.168f, 1.372f, -0.070f}}},
    {{{0.022f, 1.116f, -0.100f}, {0.044f, 1.112f, -0.140f}, {0.096f, 1.108f, -0.124f}, {0.126f, 1.108f, -0.044f}}},
    {{{0.020f, 1.040f, -0.084f}, {0.046f, 1.040f, -0.090f}, {0.086f, 1.040f, -0.078f}, {0.108f, 1.040f, -0.040f}}},
}};

}  // namespace

void add_cloak(Mesh &mesh)
{
    std::array<std::array<uint32_t, 4>, stations.size()> points{};
    for (size_t i = 0; i < stations.size(); ++i)
        for (size_t k = 0; k < 4; ++k) points[i][k] = mesh.add(stations[i][k], Region::torso);
    float along = 0;
    for (size_t i = 0; i + 1 < stations.size(); ++i) {
        const float length = glm::distance(stations[i][1], stations[i + 1][1]);
        const auto edge = [&, i](size_t k) {
            const float t = static_cast<float>(k);
            return Chain{{points[i][k], {along, t}}, {points[i + 1][k], {along + length, t}}};
        };
        for (size_t k = 0; k + 1 < 4; ++k) mesh.sew(cloak, Winding::reversed, edge(k), edge(k + 1), Along::s);
        along += length;
    }
}

}  // namespace claque::figures::plebeian
