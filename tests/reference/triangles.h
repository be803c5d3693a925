// The triangles of a file with their front sides, and whether two sets of triangles are the same surface.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "tests/reference/gltf_reference.h"

namespace claque::reference
{

using Triangle = std::array<size_t, 3>;  // vertices of the character, counter-clockwise from the front

struct Triangles {
    std::vector<Triangle> all;
    std::vector<bool> has_area;  // of each, in the rest pose: splitting may drop those that have none
};

// Lists, strips and fans of all parts. Where a rigid part's node mirrors, its front is the other side, as glTF has it.
// glTF says nothing of joints that mirror: the outside stays the outside there, too.
Triangles triangles_of(const Character &character, double size);

// For each vertex, whether a triangle with an area has it.
std::vector<bool> vertices_of(const Triangles &triangles, size_t vertex_count);

struct Facet {
    Vec3 centre;
    Vec3 area;  // as long as the area, towards the front
};

Facet facet(const Vec3 &a, const Vec3 &b, const Vec3 &c);

struct SurfaceMatching {
    bool same = false;
    size_t strays = 0, missing = 0;
    size_t turned = 0;  // strays that would not be if their front were their back
    std::string text;
};

// Every actual facet has one like it among those expected, every required one has been found, and there are no more
// than expected. Alike: centres within `distance`, areas within what moving corners that far can change.
SurfaceMatching match(const std::vector<Facet> &expected, const std::vector<bool> &required,
                      const std::vector<Facet> &actual, double distance);

}  // namespace claque::reference
