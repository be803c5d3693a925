// Closed surfaces that written characters are made of, with normals, texture coordinates and weights.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace claque::testing
{

using Triple = std::array<float, 3>;

struct Influence {
    uint16_t joint;
    float weight;
};

// A vertex has as many influences as it likes; the encoding pads them.
struct Surface {
    std::vector<Triple> positions, normals;
    std::vector<std::array<float, 2>> uvs;
    std::vector<std::vector<Influence>> influences;  // empty for rigid surfaces
    std::vector<uint32_t> indices;
};

// One ring of a tube: its centre, its radius and what moves it.
struct Ring {
    Triple centre;
    float radius;
    std::vector<Influence> influences;
};

// A part of an image, in texture coordinates.
struct UvBox {
    float u0, v0, u1, v1;
};

// A tube round rings of `sides` corners; the first and the last ring are points whatever their radius. Vertices are
// repeated along one seam, where the texture begins and ends.
Surface tube(const std::vector<Ring> &rings, uint32_t sides, const UvBox &uv);

// A box with its own corners and normals on every side.
Surface box(const Triple &centre, const Triple &half_size, const UvBox &uv);

// A sheet of two triangles a cell between four corners, seen from one side.
Surface sheet(const std::array<Triple, 4> &corners, uint32_t cells, const UvBox &uv);

void append(Surface &to, const Surface &more);

Triple plus(const Triple &a, const Triple &b);
Triple times(const Triple &a, float factor);
Triple cross(const Triple &a, const Triple &b);
Triple unit(const Triple &a);

}  // namespace claque::testing
