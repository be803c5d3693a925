#include "meshsplit/vertex_order.h"

#include <algorithm>
#include <numeric>

#include "lib/model/skin_plan.h"

namespace claque::meshsplit
{

namespace
{

// Returns the entries of a vertex, the first two ascending: model::same_entries as an order.
std::vector<uint32_t> entries_of(const Mesh &mesh, const MeshVertex &vertex)
{
    std::vector<uint32_t> out;
    for (uint32_t i = 0; i < vertex.influence_count; ++i)
        out.push_back(mesh.influences[vertex.first_influence + i].joint);
    if (out.size() > 1 && out[0] > out[1]) std::swap(out[0], out[1]);
    return out;
}

// An order in which equal lists of influences are adjacent.
bool has_lighter_influences(const Mesh &mesh, const MeshVertex &a, const MeshVertex &b)
{
    for (uint32_t i = 0; i < a.influence_count; ++i) {
        const Influence &x = mesh.influences[a.first_influence + i], &y = mesh.influences[b.first_influence + i];
        if (x.weight != y.weight) return x.weight < y.weight;
        if (x.joint != y.joint) return x.joint < y.joint;
    }
    return false;
}

}  // namespace

std::vector<uint32_t> skinning_order(const Mesh &mesh)
{
    const uint32_t count = static_cast<uint32_t>(mesh.vertices.size());
    std::vector<std::vector<uint32_t>> entries(count);
    for (uint32_t v = 0; v < count; ++v) entries[v] = entries_of(mesh, mesh.vertices[v]);
    std::vector<uint32_t> order(count);
    std::iota(order.begin(), order.end(), 0u);
    std::stable_sort(order.begin(), order.end(), [&](uint32_t a, uint32_t b) {
        if (entries[a].size() != entries[b].size()) return entries[a].size() < entries[b].size();
        if (entries[a] != entries[b]) return entries[a] < entries[b];
        return has_lighter_influences(mesh, mesh.vertices[a], mesh.vertices[b]);
    });
    std::vector<uint8_t> loose(count);
    for (uint32_t first = 0, last = 0; first < count; first = last) {
        while (last < count && entries[order[last]] == entries[order[first]]) ++last;
        for (uint32_t i = first + model::worth_blocks(last - first); i < last; ++i) loose[order[i]] = 1;
    }
    std::stable_sort(order.begin(), order.end(), [&](uint32_t a, uint32_t b) {
        if (entries[a].size() != entries[b].size()) return entries[a].size() < entries[b].size();
        return loose[a] < loose[b];
    });
    return order;
}

}  // namespace claque::meshsplit
