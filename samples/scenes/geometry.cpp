#include "samples/scenes/geometry.h"

#include <cmath>

#include "samples/scenes/angles.h"

namespace scenes
{
namespace
{

uint8_t to_byte(float value)
{
    if (value <= 0.0f) return 0;
    return value >= 1.0f ? 255 : static_cast<uint8_t>(value * 255.0f + 0.5f);
}

Vec3 unit(Vec3 v)
{
    const float length = std::sqrt(v.x * v.x + v.y * v.y + v.z * v.z);
    if (!(length > 0.0f)) return {0, 1, 0};
    return {v.x / length, v.y / length, v.z / length};
}

Vec3 cross(Vec3 a, Vec3 b) { return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x}; }

Vec3 minus(Vec3 a, Vec3 b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }

float length(Vec3 v) { return std::sqrt(v.x * v.x + v.y * v.y + v.z * v.z); }

}  // namespace

uint32_t Geometry::add(Vec3 position, Vec3 normal, float u, float v, Rgb colour, float alpha)
{
    vertices_.push_back(
        {position, normal, u, v, {to_byte(colour.r), to_byte(colour.g), to_byte(colour.b), to_byte(alpha)}});
    return static_cast<uint32_t>(vertices_.size() - 1);
}

uint32_t Geometry::add(const SceneryVertex &vertex)
{
    vertices_.push_back(vertex);
    return static_cast<uint32_t>(vertices_.size() - 1);
}

void Geometry::triangle(uint32_t a, uint32_t b, uint32_t c) { indices_.insert(indices_.end(), {a, b, c}); }

void Geometry::quad(const std::array<Vec3, 4> &p, Rgb colour)
{
    const Vec3 along = minus(p[1], p[0]), up = minus(p[3], p[0]);
    const Vec3 normal = unit(cross(along, up));
    const float wide = length(along) * per_metre_, high = length(up) * per_metre_;
    const uint32_t a = add(p[0], normal, 0, 0, colour), b = add(p[1], normal, wide, 0, colour);
    const uint32_t c = add(p[2], normal, wide, high, colour), d = add(p[3], normal, 0, high, colour);
    triangle(a, b, c);
    triangle(a, c, d);
}

void Geometry::box(Vec3 a, Vec3 b, Rgb colour)
{
    quad({Vec3{a.x, a.y, b.z}, {b.x, a.y, b.z}, {b.x, b.y, b.z}, {a.x, b.y, b.z}}, colour);
    quad({Vec3{b.x, a.y, b.z}, {b.x, a.y, a.z}, {b.x, b.y, a.z}, {b.x, b.y, b.z}}, colour);
    quad({Vec3{b.x, a.y, a.z}, {a.x, a.y, a.z}, {a.x, b.y, a.z}, {b.x, b.y, a.z}}, colour);
    quad({Vec3{a.x, a.y, a.z}, {a.x, a.y, b.z}, {a.x, b.y, b.z}, {a.x, b.y, a.z}}, colour);
    quad({Vec3{a.x, b.y, b.z}, {b.x, b.y, b.z}, {b.x, b.y, a.z}, {a.x, b.y, a.z}}, colour);
    if (a.y > 0) quad({Vec3{a.x, a.y, a.z}, {b.x, a.y, a.z}, {b.x, a.y, b.z}, {a.x, a.y, b.z}}, colour);
}

void Geometry::turned(float x, float z, const std::vector<Ring> &rings, int sides, Rgb colour)
{
    const uint32_t columns = static_cast<uint32_t>(sides) + 1;
    for (size_t ring = 0; ring + 1 < rings.size(); ++ring) {
        const Ring low = rings[ring], high = rings[ring + 1];
        const Vec3 slope = unit({high.y - low.y, low.radius - high.radius, 0});  // outwards and up
        const uint32_t first = static_cast<uint32_t>(vertices_.size());
        for (const Ring &r : {low, high})
            for (uint32_t side = 0; side < columns; ++side) {
                const double turn = two_pi * side / sides;
                const float s = static_cast<float>(std::sin(turn)), c = static_cast<float>(std::cos(turn));
                add({x + r.radius * s, r.y, z + r.radius * c}, {slope.x * s, slope.y, slope.x * c},
                    static_cast<float>(turn) * low.radius * per_metre_, r.y * per_metre_, colour);
            }
        for (uint32_t side = 0; side + 1 < columns; ++side) {
            triangle(first + side, first + side + 1, first + columns + side + 1);
            triangle(first + side, first + columns + side + 1, first + columns + side);
        }
    }
}

void Geometry::disc(float x, float y, float z, float radius, int sides, Rgb colour)
{
    const uint32_t middle = add({x, y, z}, {0, 1, 0}, x * per_metre_, z * per_metre_, colour);
    for (int side = 0; side <= sides; ++side) {
        const double turn = two_pi * side / sides;
        const float px = x + radius * static_cast<float>(std::sin(turn));
        const float pz = z + radius * static_cast<float>(std::cos(turn));
        const uint32_t rim = add({px, y, pz}, {0, 1, 0}, px * per_metre_, pz * per_metre_, colour);
        if (side > 0) triangle(middle, rim - 1, rim);
    }
}

void Geometry::draw(const Gl &g, const std::vector<uint32_t> &indices) const
{
    if (indices.empty()) return;
    constexpr int stride = sizeof(SceneryVertex);
    const SceneryVertex *v = vertices_.data();
    g.EnableClientState(gl::vertex_array);
    g.EnableClientState(gl::normal_array);
    g.EnableClientState(gl::color_array);
    g.EnableClientState(gl::texcoord_array);
    g.VertexPointer(3, gl::float_type, stride, &v->position);
    g.NormalPointer(gl::float_type, stride, &v->normal);
    g.TexCoordPointer(2, gl::float_type, stride, &v->u);
    g.ColorPointer(4, gl::unsigned_byte, stride, v->rgba);
    g.DrawElements(gl::triangles, static_cast<int>(indices.size()), gl::unsigned_int, indices.data());
    g.DisableClientState(gl::vertex_array);
    g.DisableClientState(gl::normal_array);
    g.DisableClientState(gl::color_array);
    g.DisableClientState(gl::texcoord_array);
}

void Geometry::clear()
{
    vertices_.clear();
    indices_.clear();
}

}  // namespace scenes
