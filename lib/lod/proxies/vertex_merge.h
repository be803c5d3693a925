// Triangle lists after a merge of two vertices. Internal to lib/lod/proxies.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace claque::lod
{

using Triangle = std::array<uint32_t, 3>;
using Edge = std::pair<uint32_t, uint32_t>;  // the smaller index first

inline bool has(const Triangle &t, uint32_t v) { return t[0] == v || t[1] == v || t[2] == v; }

// Returns the edge that starts at corner k.
inline Edge edge_of(const Triangle &t, size_t k)
{
    const uint32_t a = t[k], b = t[(k + 1) % 3];
    return a < b ? Edge(a, b) : Edge(b, a);
}

// Returns whether the triangles have the same vertices in opposite order.
bool are_opposite(const Triangle &a, const Triangle &b);

// Replaces `from` by `to`, and removes triangles that degenerate to a line and pairs of opposite triangles, which
// closed holes leave. A closed surface stays closed. No remaining triangle has fewer than three vertices.
std::vector<Triangle> merge_vertices(uint32_t to, uint32_t from, const std::vector<Triangle> &triangles);

// Returns the number of edge-connected components.
size_t component_count(const std::vector<Triangle> &triangles);

}  // namespace claque::lod
