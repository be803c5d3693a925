// Scenery as indexed triangles with colours, built from a few shapes and drawn as GL 1.1 vertex arrays.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "samples/scenes/gl.h"

namespace scenes
{

struct Rgb {
    float r, g, b;
};
struct Vec3 {
    float x, y, z;
};

inline Rgb operator*(Rgb c, float k) { return {c.r * k, c.g * k, c.b * k}; }

struct SceneryVertex {
    Vec3 position, normal;
    float u, v;
    uint8_t rgba[4];
};

// Faces look outwards, counter-clockwise. Shapes have a texture that repeats every texture_metres.
class Geometry
{
public:
    explicit Geometry(float texture_metres = 1.0f) : per_metre_(1.0f / texture_metres) {}

    uint32_t add(Vec3 position, Vec3 normal, float u, float v, Rgb colour, float alpha = 1.0f);
    uint32_t add(const SceneryVertex &vertex);
    void triangle(uint32_t a, uint32_t b, uint32_t c);

    // Corners counter-clockwise seen from outside.
    void quad(const std::array<Vec3, 4> &corners, Rgb colour);
    // Has no bottom, because it stands on the ground.
    void box(Vec3 first, Vec3 last, Rgb colour);
    // A surface of revolution about the vertical axis through (x, z): rings of (radius, height) from the bottom up,
    // shaded smoothly between.
    struct Ring {
        float radius, y;
    };
    void turned(float x, float z, const std::vector<Ring> &rings, int sides, Rgb colour);
    // A horizontal disc that faces up.
    void disc(float x, float y, float z, float radius, int sides, Rgb colour);

    void draw(const Gl &gl) const { draw(gl, indices_); }
    // Other triangles of the same vertices, three indices each.
    void draw(const Gl &gl, const std::vector<uint32_t> &indices) const;
    void clear();

    const std::vector<SceneryVertex> &vertices() const { return vertices_; }
    const std::vector<uint32_t> &indices() const { return indices_; }  // three a triangle

private:
    float per_metre_;
    std::vector<SceneryVertex> vertices_;
    std::vector<uint32_t> indices_;
};

}  // namespace scenes
