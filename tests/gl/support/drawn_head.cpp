#include "tests/gl/support/drawn_head.h"

#include <cmath>

namespace gltest
{

namespace
{

namespace model = claque::model;

constexpr double pi = 3.14159265358979;
constexpr uint32_t charts = 4, columns = 14, rows = 40, texels = 512;

// From 0 to 1, faster and slower by turns.
double bent(double x) { return x + 0.11 * std::sin(2 * pi * x); }

double straight(double bent_x)
{
    double low = 0, high = 1;
    for (int step = 0; step < 40; ++step) (bent((low + high) / 2) < bent_x ? low : high) = (low + high) / 2;
    return (low + high) / 2;
}

bool within(double x, double y, double at_x, double at_y, double wide, double high)
{
    return (x - at_x) * (x - at_x) / (wide * wide) + (y - at_y) * (y - at_y) / (high * high) < 1;
}

// Degrees to the left of the nose and above the middle.
std::array<uint8_t, 3> face(double x, double y)
{
    const double beside = std::fabs(x);
    if (y > 48 || (beside > 75 && y > -20)) return {70, 45, 30};
    if (within(beside, y, 24, 8, 5, 5)) return {30, 30, 40};
    if (within(beside, y, 24, 8, 12, 6)) return {240, 240, 240};
    if (within(beside, y, 24, 22, 15, 3)) return {60, 40, 30};
    if (within(x, y, 0, -32, 20, 1.5)) return {60, 15, 20};
    if (within(x, y, 0, -32, 22, 6)) return {180, 60, 60};
    if (within(x, y, 0, -10, 5, 3)) return {190, 130, 105};
    return {225, 175, 145};
}

// The charts stand side by side; every other one is upside down.
glm::vec2 uv_of(uint32_t chart, double along, double up)
{
    const double v = bent(up), room = 0.97;
    return {float((chart + 0.5 + room * (bent(along) - 0.5)) / charts),
            float(0.5 + room * ((chart % 2 ? 1 - v : v) - 0.5))};
}

double degrees_beside(uint32_t chart, double along) { return 360 * (chart + along) / charts - 180; }
double degrees_above(double up) { return 176 * up - 88; }

model::Image image()
{
    model::Image image;
    image.width = image.height = texels;
    for (uint32_t y = 0; y < texels; ++y)
        for (uint32_t x = 0; x < texels; ++x) {
            const double u = (x + 0.5) / texels * charts, v = ((y + 0.5) / texels - 0.5) / 0.97 + 0.5;
            const uint32_t chart = static_cast<uint32_t>(u);
            const std::array<uint8_t, 3> rgb = face(degrees_beside(chart, straight((u - chart - 0.5) / 0.97 + 0.5)),
                                                    degrees_above(straight(chart % 2 ? 1 - v : v)));
            image.rgba.insert(image.rgba.end(), {rgb[0], rgb[1], rgb[2], 255});
        }
    return image;
}

}  // namespace

model::Model drawn_head()
{
    model::Model made;
    made.name = "drawn head";
    made.rig.parents.push_back(model::none);
    made.rig.rest.emplace_back();
    made.rig.node_names.emplace_back("head");
    made.rig.palette.emplace_back();
    made.images.push_back(image());
    made.materials.emplace_back();
    made.materials[0].image = 0, made.materials[0].zone = 0;
    made.zones.emplace_back();
    made.zones[0].name = "all", made.zones[0].key = 255;
    made.materials[0].wrap_s = made.materials[0].wrap_t = model::Wrap::clamp;
    model::Part part;
    part.name = "head", part.node = 0, part.material = 0, part.skinned = true;
    for (uint32_t chart = 0; chart < charts; ++chart)
        for (uint32_t i = 0; i <= columns; ++i)
            for (uint32_t j = 0; j <= rows; ++j) {
                const double along = double(i) / columns, up = double(j) / rows;
                // The last column of the last chart is the first one of the first chart, to the bit.
                const double x = degrees_beside((chart + i / columns) % charts, i % columns ? along : 0) * pi / 180,
                             y = degrees_above(up) * pi / 180;
                const glm::dvec3 normal(std::sin(x) * std::cos(y), std::sin(y), std::cos(x) * std::cos(y));
                const double nose = 0.02 * std::exp(-(x * x + (y + 0.1) * (y + 0.1)) / 0.02);
                const double wide = 0.08 + nose;
                part.positions.emplace_back(wide * normal.x, 0.12 * normal.y, (wide + 0.015) * normal.z);
                part.normals.emplace_back(normal);
                part.uvs.push_back(uv_of(chart, along, up));
                if (i == columns || j == rows) continue;
                const uint32_t at = (chart * (columns + 1) + i) * (rows + 1) + j, right = at + rows + 1;
                part.indices.insert(part.indices.end(), {at, right, right + 1, at, right + 1, at + 1});
            }
    part.joints.assign(part.positions.size(), 0), part.weights.assign(part.positions.size(), 1);
    made.parts.push_back(std::move(part));
    return made;
}

}  // namespace gltest
