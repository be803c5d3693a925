// What becomes of triangles where two vertices become one. Between the files of this room only.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace claque::lod
{

using Triangle = std::array<uint32_t, 3>;
using Edge = std::pair<uint32_t, uint32_t>;  // the lower end first

inline bool has(const Triangle &t, uint32_t v) { return t[0] == v || t[1] == v || t[2] == v; }

// The edge of a triangle from corner k on.
inline Edge edge_of(const Triangle &t, size_t k)
{
    const uint32_t a = t[k], b = t[(k + 1) % 3];
    return a < b ? Edge(a, b) : Edge(b, a);
}

// The same three, the other way round.
bool are_opposite(const Triangle &a, const Triangle &b);

// `from` becomes `to`: without what becomes a line, and without pairs back to back, which closed holes leave. What was closed
// stays so. No other triangle has fewer than three vertices.
std::vector<Triangle> merge_vertices(uint32_t to, uint32_t from, const std::vector<Triangle> &triangles);

// How many pieces there are of triangles that hang together by edges.
size_t component_count(const std::vector<Triangle> &triangles);

}  // namespace claque::lod
