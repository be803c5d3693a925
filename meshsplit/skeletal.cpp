#include "meshsplit/skeletal.h"

#include <algorithm>
#include <cmath>

#include <glm/mat4x4.hpp>

#include "meshsplit/rest.h"

namespace claque::meshsplit
{

using model::none;

namespace
{

constexpr float equal_part = 1e-5f;

float largest_of(const float *values, size_t count)
{
    float maximum = 0;
    for (size_t i = 0; i < count; ++i) maximum = std::max(maximum, std::fabs(values[i]));
    return maximum;
}

bool equal(const math::Affine &a, const math::Affine &b, float extent)
{
    const float axes = std::max(largest_of(a.c, 9), largest_of(b.c, 9));
    const float way = std::max(largest_of(a.c + 9, 3), largest_of(b.c + 9, 3)) + axes * extent;
    for (size_t i = 0; i < 12; ++i)
        if (!(std::fabs(a.c[i] - b.c[i]) <= equal_part * (i < 9 ? axes : way))) return false;
    return true;
}

using EntriesOfNodes = std::vector<std::vector<uint32_t>>;

EntriesOfNodes entries_of_nodes(const model::Rig &rig)
{
    EntriesOfNodes out(rig.node_count());
    for (uint32_t e = 0; e < rig.palette.size(); ++e) out[rig.palette[e].node].push_back(e);
    return out;
}

uint32_t entry_of(model::Rig &rig, EntriesOfNodes &entries, uint32_t node, const math::Affine &inverse_bind,
                  float extent)
{
    for (const uint32_t e : entries[node])
        if (equal(rig.palette[e].inverse_bind, inverse_bind, extent)) return e;
    rig.palette.push_back({node, inverse_bind});
    entries[node].push_back(static_cast<uint32_t>(rig.palette.size() - 1));
    return entries[node].back();
}

}  // namespace

std::vector<uint32_t> surviving_entries(model::Rig &rig, const std::vector<uint8_t> &active,
                                        const std::vector<uint8_t> &used, float extent)
{
    const std::vector<math::Affine> locals = rest_locals(rig);
    EntriesOfNodes entries = entries_of_nodes(rig);
    std::vector<uint32_t> out;
    for (uint32_t e = 0; e < used.size(); ++e) {
        uint32_t node = rig.palette[e].node;
        if (!used[e] || active[node]) {
            out.push_back(e);
            continue;
        }
        glm::dmat4 place(math::mat4_of(rig.palette[e].inverse_bind));
        while (!active[node]) {
            place = glm::dmat4(math::mat4_of(locals[node])) * place;
            node = rig.parents[node];
        }
        out.push_back(entry_of(rig, entries, node, math::affine_of(glm::mat4(place)), extent));
    }
    return out;
}

}  // namespace claque::meshsplit
