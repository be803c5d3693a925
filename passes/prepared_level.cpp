// Prepares one level: short indices, the vertex ranges of its surfaces and parts, and, if all its parts are rigid, its
// vertices in the spaces of their nodes and the walk to these (S0 6.2.2).
#include <algorithm>

#include "passes/parts.h"
#include "passes/prepared.h"

namespace claque::passes
{
namespace
{

// Index 65535 stays free, as it is the common index of primitive restart.
constexpr uint32_t max_short_vertices = 65535;

VertexRange vertex_ranges_of(const model::Level &level, model::IndexRange range)
{
    VertexRange reach;
    if (range.count == 0) return reach;
    const auto first = level.indices.begin() + range.first;
    const auto bounds = std::minmax_element(first, first + range.count);
    return {*bounds.first, *bounds.second + 1};
}

void widen(VertexRange &range, uint32_t vertex)
{
    if (range.first == range.end) range = {vertex, vertex + 1};
    range = {std::min(range.first, vertex), std::max(range.end, vertex + 1)};
}

PartVertexRanges vertex_ranges_of(const model::Level &level, const IndexSlices &slices, uint32_t part)
{
    PartVertexRanges reach;
    for (size_t s = 0; s < slices.count(); ++s) {
        const model::IndexRange share = part_of(slices[s], part);
        for (uint32_t i = share.first; i < share.first + share.count; ++i) {
            const uint32_t vertex = level.indices[i];
            widen(vertex < level.source_count ? reach.sources : reach.copies, vertex);
        }
    }
    return reach;
}

// The palette entry that each source vertex follows; empty unless each follows one valid entry.
std::vector<uint32_t> entries_of(const model::Template &source, const model::Level &level)
{
    std::vector<uint32_t> entries;
    for (const model::InfluenceRun &run : level.runs) {
        if (run.influences != 1 || run.first != entries.size() || run.count > level.source_count - run.first ||
            uint64_t(run.first_influence) + run.count > level.joints.size())
            return {};
        entries.insert(entries.end(), level.joints.begin() + run.first_influence,
                       level.joints.begin() + run.first_influence + run.count);
    }
    const auto is = [&](uint32_t e) {
        return e < source.rig.palette.size() && source.rig.palette[e].node < source.rig.node_count();
    };
    if (entries.size() != level.source_count || !std::all_of(entries.begin(), entries.end(), is)) return {};
    return entries;
}

// The node that all vertices of a part follow; none if there are several. For a part without vertices: its own node.
uint32_t node_of(const model::Template &source, const model::Level &level, const std::vector<uint32_t> &entries,
                 uint32_t part)
{
    uint32_t node = model::none;
    for (const model::Surface &surface : level.surfaces) {
        const IndexSlices slices(level, surface);
        for (size_t s = 0; s < slices.count(); ++s) {
            const model::IndexRange share = part_of(slices[s], part);
            for (uint32_t i = share.first; i < share.first + share.count; ++i) {
                const uint32_t vertex = level.indices[i];
                const uint32_t from = vertex < level.source_count ? vertex : level.copies[vertex - level.source_count];
                const uint32_t follows = source.rig.palette[entries[from]].node;
                if (node != model::none && node != follows) return model::none;
                node = follows;
            }
        }
    }
    return node == model::none ? std::min(level.parts[part].node, source.rig.node_count() - 1) : node;
}

// The nodes that have parts on or below them, in depth-first order.
void plan_walk(Array<MatrixStep> &steps, const model::Rig &rig, const std::vector<uint64_t> &own)
{
    std::vector<uint64_t> below(own);
    std::vector<std::vector<uint32_t>> children(rig.node_count() + 1);  // the last: roots
    for (uint32_t n = rig.node_count(); n-- > 0;) {
        if (below[n] == 0) continue;
        const bool root = rig.parents[n] == model::none;
        if (!root) below[rig.parents[n]] |= below[n];
        children[root ? rig.node_count() : rig.parents[n]].push_back(n);  // descending, for the stack
    }
    struct Waiting {
        uint32_t node, depth;
    };
    std::vector<Waiting> stack;
    for (const uint32_t n : children.back()) stack.push_back({n, 1});
    while (!stack.empty()) {
        const Waiting at = stack.back();
        stack.pop_back();
        steps.push_back({at.node, at.depth, 0, own[at.node], below[at.node]});
        for (const uint32_t n : children[at.node]) stack.push_back({n, at.depth + 1});
    }
    const uint32_t count = static_cast<uint32_t>(steps.size());
    for (uint32_t i = count; i-- > 0;) {
        uint32_t next = i + 1;
        while (next < count && steps[next].depth > steps[i].depth) next = steps[next].next;
        steps[i].next = next;
    }
}

void push(Array<float> &array, glm::vec3 v) { array.insert(array.end(), {v.x, v.y, v.z}); }

void place_in_nodes(PreparedLevel &out, const model::Template &source, const model::Level &level,
                    const std::vector<uint32_t> &entries)
{
    out.positions.reserve(3 * size_t(level.vertex_count));
    out.normals.reserve(3 * size_t(level.vertex_count));
    for (uint32_t v = 0; v < level.vertex_count; ++v) {
        const uint32_t from = v < level.source_count ? v : level.copies[v - level.source_count];
        const math::Affine &bind = source.rig.palette[entries[from]].inverse_bind;
        const float *p = &level.positions[3 * size_t(from)], *n = &level.normals[3 * size_t(from)];
        push(out.positions, math::transform_point(bind, glm::vec3(p[0], p[1], p[2])));
        push(out.normals, math::transform_vector(math::normal_matrix(bind), glm::vec3(n[0], n[1], n[2])));
    }
}

bool lengths_match(const model::Template &source, const model::Level &level)
{
    const auto is_parent = [&](uint32_t n) {
        return source.rig.parents[n] == model::none || source.rig.parents[n] < n;
    };
    for (uint32_t n = 0; n < source.rig.node_count(); ++n)
        if (!is_parent(n)) return false;
    return source.rig.node_count() > 0 && level.positions.size() == 3 * size_t(level.source_count) &&
           level.normals.size() == level.positions.size() &&
           level.copies.size() == level.vertex_count - level.source_count &&
           std::all_of(level.copies.begin(), level.copies.end(), [&](uint32_t c) { return c < level.source_count; });
}

}  // namespace

void prepare_ranges(PreparedLevel &out, const model::Level &level)
{
    if (level.vertex_count <= max_short_vertices) out.short_indices.assign(level.indices.begin(), level.indices.end());
    for (const model::Surface &surface : level.surfaces) {
        out.fused_vertices.push_back(vertex_ranges_of(level, surface.fused));
        if (part_count_of(level) == 1) continue;
        const IndexSlices slices(level, surface);
        for (uint32_t part = 0; part < level.parts.size(); ++part)
            out.part_vertex_ranges.push_back(vertex_ranges_of(level, slices, part));
    }
}

void prepare_shadow(PreparedLevel &out, const model::Level &level)
{
    const auto add = [&](model::IndexRange share) {
        const auto first = level.indices.begin() + std::ptrdiff_t(share.first);
        out.shadow_indices.insert(out.shadow_indices.end(), first, first + std::ptrdiff_t(share.count));
    };
    for (uint32_t part = 0; part < part_count_of(level); ++part) {
        out.shadow_firsts.push_back(static_cast<uint32_t>(out.shadow_indices.size()));
        for (const model::Surface &surface : level.surfaces) {
            const IndexSlices slices(level, surface);
            for (size_t bin = 0; bin < surface.clean.size(); ++bin) add(part_of(slices.clean(bin), part));
            add(part_of(slices.dirty(), part));
        }
    }
    out.shadow_firsts.push_back(static_cast<uint32_t>(out.shadow_indices.size()));
}

bool prepare_rigid(PreparedLevel &out, const model::Template &source, const model::Level &level)
{
    if (level.source_count == 0) return level.indices.empty();
    const std::vector<uint32_t> entries = entries_of(source, level);
    if (entries.empty() || level.parts.empty() || !lengths_match(source, level)) return false;
    std::vector<uint64_t> own(source.rig.node_count(), 0);
    for (uint32_t part = 0; part < level.parts.size(); ++part) {
        const uint32_t node = node_of(source, level, entries, part);
        if (node == model::none) return false;
        own[node] |= uint64_t(1) << part;
    }
    plan_walk(out.steps, source.rig, own);
    place_in_nodes(out, source, level, entries);
    return true;
}

}  // namespace claque::passes
