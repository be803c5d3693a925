// The balteus, a roll of gathered cloth in a loop from under the right arm over the left shoulder and down the back,
// and the umbo, cloth pulled out from under it over the belly. Their edges lie inside the dress, so they have no inner
// side.
#include <glm/geometric.hpp>

#include "lib/figures/decurion/decurion.h"

namespace claque::figures::decurion
{

namespace
{

// From the edge towards the neck and right over two ridges to the edge towards the arm and left.
using Station = std::array<glm::vec3, 4>;

const std::array<Station, 10> stations = {{
    // right side, where the loop begins and ends
    {{{-0.168f, 1.198f, 0.006f}, {-0.206f, 1.176f, 0.004f}, {-0.228f, 1.122f, 0.004f}, {-0.198f, 1.078f, 0.004f}}},
    {{{-0.112f, 1.222f, 0.090f}, {-0.144f, 1.196f, 0.142f}, {-0.158f, 1.138f, 0.160f}, {-0.136f, 1.082f, 0.136f}}},
    {{{-0.012f, 1.278f, 0.122f}, {-0.006f, 1.252f, 0.176f}, {0.004f, 1.190f, 0.204f}, {0.010f, 1.122f, 0.182f}}},
    {{{0.040f, 1.346f, 0.110f}, {0.062f, 1.328f, 0.164f}, {0.106f, 1.266f, 0.154f}, {0.122f, 1.190f, 0.098f}}},
    {{{0.060f, 1.404f, 0.088f}, {0.084f, 1.400f, 0.134f}, {0.134f, 1.372f, 0.120f}, {0.166f, 1.340f, 0.050f}}},
    {{{0.088f, 1.450f, -0.010f}, {0.106f, 1.494f, -0.018f}, {0.152f, 1.490f, -0.020f}, {0.190f, 1.440f, -0.016f}}},
    {{{0.046f, 1.424f, -0.098f}, {0.072f, 1.418f, -0.138f}, {0.128f, 1.394f, -0.134f}, {0.168f, 1.350f, -0.076f}}},
    {{{-0.015f, 1.350f, -0.116f}, {0.006f, 1.326f, -0.160f}, {0.064f, 1.262f, -0.162f}, {0.118f, 1.180f, -0.088f}}},
    {{{-0.076f, 1.262f, -0.088f}, {-0.070f, 1.236f, -0.152f}, {-0.040f, 1.172f, -0.170f}, {0, 1.108f, -0.132f}}},
    {{{-0.132f, 1.216f, -0.056f}, {-0.158f, 1.192f, -0.108f}, {-0.166f, 1.136f, -0.130f}, {-0.140f, 1.078f, -0.100f}}},
}};

// From above; each row from the middle of the body to its left.
const std::array<Station, 4> pouch = {{
    {{{0.030f, 1.215f, 0.142f}, {0.072f, 1.235f, 0.154f}, {0.120f, 1.252f, 0.128f}, {0.142f, 1.256f, 0.024f}}},
    {{{0.016f, 1.115f, 0.178f}, {0.058f, 1.105f, 0.216f}, {0.132f, 1.110f, 0.172f}, {0.172f, 1.130f, 0.070f}}},
    {{{0.050f, 0.975f, 0.190f}, {0.086f, 0.955f, 0.216f}, {0.144f, 0.965f, 0.178f}, {0.186f, 0.990f, 0.090f}}},
    {{{0.084f, 0.850f, 0.176f}, {0.112f, 0.815f, 0.190f}, {0.154f, 0.835f, 0.152f}, {0.184f, 0.870f, 0.090f}}},
}};

void add_umbo(Mesh &mesh)
{
    std::vector<Chain> rows;
    for (const Station &station : pouch) {
        rows.emplace_back();
        for (size_t k = 0; k < 4; ++k)
            rows.back().push_back({mesh.add(station[k], station[k].y < 1.03f ? Region::gown : wrap),
                                   {static_cast<float>(k), station[1].y}});
    }
    for (size_t r = 0; r + 1 < rows.size(); ++r) mesh.sew(umbo, Winding::as_given, rows[r + 1], rows[r], Along::s);
}

}  // namespace

void add_balteus(Mesh &mesh)
{
    std::vector<std::array<uint32_t, 4>> points;
    for (const Station &station : stations) {
        points.emplace_back();
        for (size_t k = 0; k < 4; ++k) points.back()[k] = mesh.add(station[k], wrap);
    }
    float along = 0;
    for (size_t i = 0; i < stations.size(); ++i) {
        const size_t next = (i + 1) % stations.size();
        const float length = glm::distance(stations[i][1], stations[next][1]);
        for (size_t k = 0; k + 1 < 4; ++k) {
            const float a = static_cast<float>(k), b = static_cast<float>(k + 1);
            mesh.sew(balteus, Winding::reversed, {{points[i][k], {along, a}}, {points[next][k], {along + length, a}}},
                     {{points[i][k + 1], {along, b}}, {points[next][k + 1], {along + length, b}}}, Along::s);
        }
        along += length;
    }
    add_umbo(mesh);
}

}  // namespace claque::figures::decurion
