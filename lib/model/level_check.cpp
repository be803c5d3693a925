#include "lib/model/level_check.h"

namespace claque::model
{

using base::fail;

namespace
{

void check_runs(const Level &level, size_t palette_count)
{
    uint64_t vertex = 0, influence = 0;
    uint32_t influences = 0;
    for (const InfluenceRun &run : level.runs) {
        if (run.first != vertex || run.count == 0 || run.influences <= influences)
            fail(CLQ_ARGUMENT, "runs of influences do not follow each other at vertex %u", run.first);
        if (run.first_influence != influence || influence + uint64_t(run.count) * run.influences > level.joints.size())
            fail(CLQ_ARGUMENT, "the run of influences at vertex %u is out of range", run.first);
        vertex += run.count;
        influence += uint64_t(run.count) * run.influences;
        influences = run.influences;
    }
    if (vertex != level.source_count)
        fail(CLQ_ARGUMENT, "runs of influences hold %llu vertices: all %u are wanted",
             static_cast<unsigned long long>(vertex), level.source_count);
    require_count(level.weights.size(), level.joints.size(), "weights");
    require_finite(level.weights.data(), level.weights.size(), "weights");
    for (const uint16_t joint : level.joints)
        if (joint >= palette_count)
            fail(CLQ_ARGUMENT, "a vertex follows matrix %u, which does not exist: there are %zu", joint, palette_count);
}

void check_morphs(const Level &level, size_t weight_count)
{
    for (const MorphRange &range : level.morph_ranges)
        if (range.weight >= weight_count || uint64_t(range.first) + range.count > level.morph_deltas.size())
            fail(CLQ_ARGUMENT, "a range of morph deltas of weight %u is out of range", range.weight);
    for (const MorphDelta &delta : level.morph_deltas) {
        if (delta.vertex >= level.source_count)
            fail(CLQ_ARGUMENT, "a morph delta is of vertex %u, which does not exist: there are %u", delta.vertex,
                 level.source_count);
        require_finite(delta.position, 3, "morph delta");
        require_finite(delta.normal, 3, "morph delta");
    }
}

void check_vertices(const Level &level)
{
    const uint64_t count = uint64_t(level.source_count) + level.copies.size();
    if (count != level.vertex_count)
        fail(CLQ_ARGUMENT, "%u vertices, of which %u are skinned and %zu are copies", level.vertex_count,
             level.source_count, level.copies.size());
    require_count(level.positions.size(), size_t(3) * level.source_count, "positions");
    require_count(level.normals.size(), size_t(3) * level.source_count, "normals");
    require_count(level.uvs.size(), size_t(2) * level.vertex_count, "texture coordinates");
    require_count(level.slots.size(), level.vertex_count, "slots");
    if (!level.colours.empty()) require_count(level.colours.size(), size_t(4) * level.vertex_count, "colours");
    require_finite(level.positions.data(), level.positions.size(), "positions");
    require_finite(level.normals.data(), level.normals.size(), "normals");
    require_finite(level.uvs.data(), level.uvs.size(), "texture coordinates");
    for (const uint32_t source : level.copies)
        if (source >= level.source_count)
            fail(CLQ_ARGUMENT, "a vertex is a copy of vertex %u, which does not exist: there are %u", source,
                 level.source_count);
}

void check_range(const Level &level, const IndexRange &range, uint32_t vertices)
{
    if (range.count % 3 != 0 || uint64_t(range.first) + range.count > level.indices.size())
        fail(CLQ_ARGUMENT, "indices %u to %llu are no whole triangles, or do not exist: there are %zu", range.first,
             static_cast<unsigned long long>(uint64_t(range.first) + range.count), level.indices.size());
    for (uint32_t i = range.first; i < range.first + range.count; ++i)
        if (level.indices[i] >= vertices)
            fail(CLQ_ARGUMENT, "index %u names vertex %u, which does not exist: there are %u", i, level.indices[i],
                 vertices);
}

void check_bins(const Level &level, const Array<Bin> &bins, size_t zones)
{
    for (size_t i = 0; i < bins.size(); ++i) {
        if (bins[i].zone_index >= zones || (i > 0 && bins[i].zone_index <= bins[i - 1].zone_index))
            fail(CLQ_ARGUMENT, "bin %zu is of zone %u, which does not exist: its texture has %zu", i,
                 bins[i].zone_index, zones);
        check_range(level, bins[i].range, level.source_count);
    }
}

void check_surface(const Template &tmpl, const Level &level, const Surface &surface)
{
    if (surface.texture >= tmpl.textures.size())
        fail(CLQ_ARGUMENT, "a surface has texture %u, which does not exist: there are %zu", surface.texture,
             tmpl.textures.size());
    for (const float e : surface.lighting.emission)
        if (!(e >= 0 && e <= 1)) fail(CLQ_ARGUMENT, "a surface emits %g: [0, 1] is wanted", double(e));
    const size_t zones = tmpl.textures[surface.texture].keys.size();
    check_bins(level, surface.clean, zones);
    check_bins(level, surface.dirty_by_zone, zones);
    check_range(level, surface.dirty, level.source_count);
    check_range(level, surface.fused, level.vertex_count);
    for (uint32_t i = surface.fused.first; i < surface.fused.first + surface.fused.count; ++i)
        if (level.slots[level.indices[i]] >= 2 * zones)
            fail(CLQ_ARGUMENT, "vertex %u has slot %u where its texture has %zu zones", level.indices[i],
                 level.slots[level.indices[i]], zones);
}

// Every range of a surface has indices of its own, so checking them all reads each index once. Indices of no range are
// not drawn, but a renderer gives GL the whole array.
void check_surfaces(const Template &tmpl, const Level &level)
{
    for (size_t i = 0; i < level.indices.size(); ++i)
        if (level.indices[i] >= level.vertex_count)
            fail(CLQ_ARGUMENT, "index %zu names vertex %u, which does not exist: there are %u", i, level.indices[i],
                 level.vertex_count);
    uint64_t taken = 0;
    for (const Surface &surface : level.surfaces) {
        taken += uint64_t(surface.dirty.count) + surface.fused.count;
        for (const Bin &bin : surface.clean) taken += bin.range.count;
        for (const Bin &bin : surface.dirty_by_zone) taken += bin.range.count;
    }
    if (taken > level.indices.size())
        fail(CLQ_ARGUMENT, "%zu surfaces take %llu indices of %zu: ranges overlap", level.surfaces.size(),
             static_cast<unsigned long long>(taken), level.indices.size());
    for (const Surface &surface : level.surfaces) check_surface(tmpl, level, surface);
}

// A level without vertices must be empty in everything else.
void check_empty(const Level &level, size_t index)
{
    if (level.source_count > 0) return;
    if (index == 0) fail(CLQ_ARGUMENT, "a template has no vertex at its first level");
    if (!level.surfaces.empty() || !level.indices.empty())
        fail(CLQ_ARGUMENT, "level %zu has %zu surfaces and %zu indices without a vertex", index, level.surfaces.size(),
             level.indices.size());
}

void check_distance(const Template &tmpl, size_t index)
{
    const float own = tmpl.levels[index].switch_distance_m;
    require_finite(&own, 1, "switch distance");
    if (index == 0 ? own != 0 : !(own > tmpl.levels[index - 1].switch_distance_m))
        fail(CLQ_ARGUMENT, "level %zu begins at %g m: distances begin at 0 and ascend", index,
             static_cast<double>(own));
}

}  // namespace

void check_levels(const Template &tmpl)
{
    if (tmpl.levels.empty()) fail(CLQ_ARGUMENT, "a template has no level: 1 or more are wanted");
    if (tmpl.levels.size() > max_levels)
        fail(CLQ_ARGUMENT, "a template has %zu levels: %zu are the most", tmpl.levels.size(), max_levels);
    for (size_t i = 0; i < tmpl.levels.size(); ++i) {
        const Level &level = tmpl.levels[i];
        check_distance(tmpl, i);
        check_vertices(level);
        check_empty(level, i);
        check_runs(level, tmpl.rig.palette.size());
        check_morphs(level, tmpl.rig.rest_weights.size());
        check_surfaces(tmpl, level);
        check_parts(tmpl, level);
        check_part_firsts(level);
        check_skeleton(tmpl, i);
    }
}

}  // namespace claque::model
