// Whether a surface is closed.
#pragma once

#include <limits>
#include <map>
#include <utility>

#include "lib/lod/proxies/marching_tetrahedra.h"

namespace claque::test
{

// Each directed edge occurs as often as its opposite, and at most `most` times: with 1, two triangles of the same
// orientation meet at every edge.
inline bool is_closed(const lod::ClosedMesh &surface, int most = std::numeric_limits<int>::max())
{
    std::map<std::pair<uint32_t, uint32_t>, int> edges;
    for (const auto &t : surface.triangles)
        for (size_t k = 0; k < 3; ++k) ++edges[{t[k], t[(k + 1) % 3]}];
    for (const auto &[edge, count] : edges) {
        const auto back = edges.find({edge.second, edge.first});
        if (count > most || back == edges.end() || back->second != count) return false;
    }
    return !edges.empty();
}

}  // namespace claque::test
