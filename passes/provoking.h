// Chooses the provoking vertex of each triangle of a FlatLevel: the vertex whose colour and normal GL_FLAT shows on all
// of the triangle.
#pragma once

#include <array>
#include <vector>

#include <glm/vec3.hpp>

namespace claque::passes
{

struct FlatTriangle {
    std::array<uint32_t, 3> vertices = {0, 0, 0};  // of its corners; neighbours share them
    uint32_t colour_entry = 0;                     // what it shows
    glm::vec3 normal = glm::vec3(0);               // its unit normal in the rest pose
};

// A provoking vertex. Its triangles have one colour entry and about one direction, as one normal lights them all.
struct Provoking {
    uint32_t vertex = 0, colour_entry = 0;
    std::vector<uint32_t> triangles;
};

// Assigns every triangle to one of its corners so that few vertices are sent: one for each result, and one for each
// welded vertex where no triangle ends. Deterministic.
std::vector<Provoking> provoking_vertices(const std::vector<FlatTriangle> &triangles);

}  // namespace claque::passes
