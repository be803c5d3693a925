// The palla's upper part, a broad band of gathered cloth: from the waist up over the left shoulder, diagonally down the
// back, and as a roll round the right hip to the left one. Its edges lie inside the dress, so it has no inner side.
#include <glm/geometric.hpp>

#include "lib/figures/patrician/patrician.h"

namespace claque::figures::patrician
{

namespace
{

// A cross-section of the band: its edge towards neck and right, two ridges, the edge towards arm and left.
struct CrossSection {
    std::array<glm::vec3, 4> across;
};

const std::array<CrossSection, 14> stations = {{
    // left, tucked behind the roll at the waist
    {{{{0.040f, 1.100f, 0.098f}, {0.062f, 1.090f, 0.146f}, {0.104f, 1.090f, 0.136f}, {0.118f, 1.090f, 0.072f}}}},
    {{{{0.044f, 1.205f, 0.080f}, {0.064f, 1.205f, 0.134f}, {0.102f, 1.200f, 0.124f}, {0.110f, 1.200f, 0.048f}}}},
    {{{{0.050f, 1.285f, 0.134f}, {0.070f, 1.288f, 0.176f}, {0.112f, 1.280f, 0.146f}, {0.134f, 1.285f, 0.044f}}}},
    {{{{0.070f, 1.400f, 0.094f}, {0.086f, 1.394f, 0.128f}, {0.126f, 1.376f, 0.110f}, {0.138f, 1.350f, 0.050f}}}},
    // the shoulder
    {{{{0.088f, 1.450f, -0.010f}, {0.108f, 1.480f, -0.018f}, {0.146f, 1.478f, -0.020f}, {0.180f, 1.440f, -0.016f}}}},
    {{{{0.048f, 1.420f, -0.092f}, {0.070f, 1.412f, -0.126f}, {0.122f, 1.390f, -0.126f}, {0.136f, 1.362f, -0.076f}}}},
    {{{{-0.010f, 1.330f, -0.108f}, {0.012f, 1.300f, -0.146f}, {0.070f, 1.240f, -0.146f}, {0.104f, 1.160f, -0.066f}}}},
    {{{{-0.070f, 1.220f, -0.084f}, {-0.060f, 1.184f, -0.136f}, {-0.030f, 1.100f, -0.150f}, {0.010f, 1.010f, -0.124f}}}},
    {{{{-0.120f, 1.150f, -0.050f},
       {-0.136f, 1.106f, -0.090f},
       {-0.134f, 1.020f, -0.118f},
       {-0.126f, 0.950f, -0.108f}}}},
    // the right hip
    {{{{-0.146f, 1.100f, 0.030f}, {-0.172f, 1.062f, 0.020f}, {-0.180f, 1.000f, 0.012f}, {-0.172f, 0.950f, 0.010f}}}},
    {{{{-0.080f, 1.110f, 0.098f}, {-0.094f, 1.074f, 0.140f}, {-0.110f, 1.010f, 0.148f}, {-0.122f, 0.965f, 0.112f}}}},
    {{{{0.006f, 1.112f, 0.112f}, {0.010f, 1.080f, 0.166f}, {0.012f, 1.022f, 0.168f}, {0.012f, 0.975f, 0.122f}}}},
    {{{{0.092f, 1.140f, 0.080f}, {0.106f, 1.106f, 0.124f}, {0.116f, 1.046f, 0.126f}, {0.118f, 0.990f, 0.090f}}}},
    // the left hip, where it goes into the dress
    {{{{0.134f, 1.170f, 0}, {0.144f, 1.120f, 0}, {0.150f, 1.060f, 0}, {0.158f, 1.000f, 0}}}},
}};

}  // namespace

void add_palla(Mesh &mesh)
{
    std::vector<std::array<uint32_t, 4>> points;
    for (const CrossSection &station : stations) {
        points.emplace_back();
        for (size_t k = 0; k < 4; ++k) {
            const glm::vec3 p = station.across[k];
            points.back()[k] = mesh.add(p, p.y < 1.03f ? heavy_cloth : Region::torso);
        }
    }
    float along = 0;
    for (size_t i = 0; i + 1 < stations.size(); ++i) {
        const size_t next = i + 1;
        const float length = glm::distance(stations[i].across[1], stations[next].across[1]);
        for (size_t k = 0; k + 1 < 4; ++k) {
            const float a = static_cast<float>(k), b = static_cast<float>(k + 1);
            mesh.sew(palla, Winding::reversed, {{points[i][k], {along, a}}, {points[next][k], {along + length, a}}},
                     {{points[i][k + 1], {along, b}}, {points[next][k + 1], {along + length, b}}}, Along::s);
        }
        along += length;
    }
}

}  // namespace claque::figures::patrician
