#include "samples/scenes/light_map.h"

#include <algorithm>
#include <cmath>

namespace scenes
{
namespace
{

constexpr int side_px = 1024;
constexpr double ground_grey = 0.35;  // brightness of the ground, against 0.1 of a shadow's own colour
constexpr double least = 1 - Shadows::darkness * (1 - 0.1 / ground_grey);

struct Span {
    int first, last;
};

Span texels_between(double a, double b, double c)
{
    const auto clamped = [](double at) { return static_cast<int>(std::clamp(at, 0.0, side_px - 1.0)); };
    return {clamped(std::min({a, b, c, b + c - a})), clamped(std::max({a, b, c, b + c - a}))};
}

}  // namespace

LightMap::LightMap(float low, float high) : low_(low), high_(high)
{
    image_.side_px = side_px;
    image_.rgba.assign(4 * size_t(side_px) * side_px, 255);
}

void LightMap::paint(const Shadows &shadows)
{
    const Image picture = Shadows::picture();
    const std::vector<SceneryVertex> &vertices = shadows.people().vertices();
    for (size_t i = 0; i + 4 <= vertices.size(); i += 4) darken(&vertices[i], picture);
}

// A quad is a parallelogram: its first corner, and the edges along u and along v.
void LightMap::darken(const SceneryVertex *quad, const Image &picture)
{
    const auto texel = [&](float metres) { return static_cast<double>(coordinate(metres)) * side_px; };
    const double x = texel(quad[0].position.x), z = texel(quad[0].position.z);
    const double ux = texel(quad[1].position.x) - x, uz = texel(quad[1].position.z) - z;
    const double vx = texel(quad[3].position.x) - x, vz = texel(quad[3].position.z) - z;
    const double area = ux * vz - uz * vx;
    if (area == 0) return;
    const Span columns = texels_between(x, x + ux, x + vx), rows = texels_between(z, z + uz, z + vz);
    for (int row = rows.first; row <= rows.last; ++row)
        for (int column = columns.first; column <= columns.last; ++column) {
            const double dx = column + 0.5 - x, dz = row + 0.5 - z;
            const double along_u = (dx * vz - dz * vx) / area, along_v = (ux * dz - uz * dx) / area;
            if (along_u < 0 || along_u >= 1 || along_v < 0 || along_v >= 1) continue;
            const double u = double(quad[0].u) + along_u * double(quad[1].u - quad[0].u);
            const double v = double(quad[0].v) + along_v * double(quad[3].v - quad[0].v);
            const size_t at = static_cast<size_t>(v * picture.side_px) * static_cast<size_t>(picture.side_px) +
                              static_cast<size_t>(u * picture.side_px);
            const double shade = 1 - (1 - least) * picture.rgba[4 * at + 3] / 255.0;
            uint8_t *to = &image_.rgba[4 * (static_cast<size_t>(row) * side_px + static_cast<size_t>(column))];
            for (int channel = 0; channel < 3; ++channel) to[channel] = static_cast<uint8_t>(to[channel] * shade + 0.5);
        }
}

}  // namespace scenes
