// Which vertex each triangle of a level in a colour a triangle ends at: its provoking vertex, whose colour and normal GL_FLAT
// shows on all of it.
#pragma once

#include <glm/vec3.hpp>

#include <array>
#include <vector>

namespace claque::passes
{

struct FlatTriangle {
    std::array<uint32_t, 3> vertices = {0, 0, 0};  // of its corners; those of neighbours are the same
    uint32_t colour_entry = 0;                     // what it shows
    glm::vec3 normal = glm::vec3(0);               // its unit normal at rest
};

// A provoking vertex. Its triangles show one look, and face about one way, as all are lit by one normal.
struct Provoking {
    uint32_t vertex = 0, colour_entry = 0;
    std::vector<uint32_t> triangles;
};

// Every triangle at one of its corners, so that few vertices are sent: one for each of these, and one for each place where
// no triangle ends. Deterministic.
std::vector<Provoking> provoking_vertices(const std::vector<FlatTriangle> &triangles);

}  // namespace claque::passes
