#include "lib/lod/proxies/vertex_merge.h"

#include <algorithm>
#include <map>
#include <numeric>

namespace claque::lod
{

bool are_opposite(const Triangle &a, const Triangle &b)
{
    for (size_t k = 0; k < 3; ++k)
        if (a[0] == b[k]) return a[1] == b[(k + 2) % 3] && a[2] == b[(k + 1) % 3];
    return false;
}

std::vector<Triangle> merge_vertices(uint32_t to, uint32_t from, const std::vector<Triangle> &triangles)
{
    std::vector<Triangle> left;
    for (Triangle t : triangles) {
        if (has(t, to) && has(t, from)) continue;
        std::replace(t.begin(), t.end(), from, to);
        const auto other =
            std::find_if(left.begin(), left.end(), [&](const Triangle &o) { return are_opposite(o, t); });
        if (other != left.end()) left.erase(other);
        else left.push_back(t);
    }
    return left;
}

size_t component_count(const std::vector<Triangle> &triangles)
{
    std::vector<size_t> piece(triangles.size());
    std::iota(piece.begin(), piece.end(), size_t(0));
    const auto root = [&](size_t i) {
        while (piece[i] != i) i = piece[i] = piece[piece[i]];
        return i;
    };
    std::map<Edge, size_t> first;
    for (size_t t = 0; t < triangles.size(); ++t)
        for (size_t k = 0; k < 3; ++k)
            piece[root(t)] = root(first.try_emplace(edge_of(triangles[t], k), t).first->second);
    size_t count = 0;
    for (size_t t = 0; t < triangles.size(); ++t) count += piece[t] == t;
    return count;
}

}  // namespace claque::lod
