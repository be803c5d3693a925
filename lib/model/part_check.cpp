// The rules of skeletal levels (S0 5.2) and of parts (S0 4.1).
#include "lib/model/level_check.h"

namespace claque::model
{

using base::fail;

namespace
{

uint64_t triangles_of(const Level &level)
{
    uint64_t indices = 0;
    for (const Surface &surface : level.surfaces) {
        for (const Bin &bin : surface.clean) indices += bin.range.count;
        indices += surface.dirty.count;
    }
    return indices / 3;
}

void check_sphere(const Template &tmpl, const PartSphere &sphere)
{
    if (sphere.entry >= tmpl.rig.palette.size())
        fail(CLQ_ARGUMENT, "a sphere of a part follows matrix %u, which does not exist: there are %zu", sphere.entry,
             tmpl.rig.palette.size());
    require_finite(&sphere.bind.centre.x, 3, "centre of a part's sphere");
    require_finite(&sphere.bind.radius, 1, "radius of a part's sphere");
    if (sphere.bind.radius < 0) fail(CLQ_ARGUMENT, "a part's sphere of negative radius");
}

void check_part(const Template &tmpl, const Level &level, size_t index)
{
    const LevelPart &part = level.parts[index];
    if (part.node >= tmpl.rig.node_count())
        fail(CLQ_ARGUMENT, "part %zu hangs on node %u, which does not exist: there are %u", index, part.node,
             tmpl.rig.node_count());
    const uint64_t first =
        index == 0 ? 0 : uint64_t(level.parts[index - 1].first_sphere) + level.parts[index - 1].sphere_count;
    if (part.first_sphere != first || part.sphere_count == 0 ||
        uint64_t(part.first_sphere) + part.sphere_count > level.part_spheres.size())
        fail(CLQ_ARGUMENT, "part %zu has spheres %u to %llu: they follow those of the part before, and there are %zu",
             index, part.first_sphere, static_cast<unsigned long long>(uint64_t(part.first_sphere) + part.sphere_count),
             level.part_spheres.size());
    for (uint32_t i = 1; i < part.sphere_count; ++i)
        if (level.part_spheres[part.first_sphere + i].entry <= level.part_spheres[part.first_sphere + i - 1].entry)
            fail(CLQ_ARGUMENT, "part %zu has spheres of matrices that do not ascend", index);
}

// Offsets rise by whole triangles from 0 to the size of the range.
void check_firsts(const uint32_t *firsts, size_t parts, uint32_t count, std::vector<uint64_t> *triangles)
{
    if (firsts[0] != 0 || firsts[parts] != count)
        fail(CLQ_ARGUMENT, "parts take %u to %u of a range of %u indices", firsts[0], firsts[parts], count);
    for (size_t p = 0; p < parts; ++p) {
        if (firsts[p + 1] < firsts[p] || firsts[p] % 3 != 0)
            fail(CLQ_ARGUMENT, "part %zu takes %u to %u of a range of indices", p, firsts[p], firsts[p + 1]);
        if (triangles) (*triangles)[p] += (firsts[p + 1] - firsts[p]) / 3;
    }
}

void check_entries(const Template &tmpl, const Level &level)
{
    std::vector<bool> kept(tmpl.rig.palette.size());
    for (size_t i = 0; i < level.entries.size(); ++i) {
        const uint32_t entry = level.entries[i];
        if (entry >= kept.size() || (i > 0 && entry <= level.entries[i - 1]))
            fail(CLQ_ARGUMENT,
                 "a level asks for matrix %u, which does not exist (there are %zu) or was asked for before", entry,
                 kept.size());
        if (!level.active[tmpl.rig.palette[entry].node])
            fail(CLQ_ARGUMENT, "a level asks for matrix %u, whose node has stopped", entry);
        kept[entry] = true;
    }
    for (const uint16_t joint : level.joints)
        if (!kept[joint]) fail(CLQ_ARGUMENT, "a vertex follows matrix %u, which its level does not ask for", joint);
    for (const LevelPart &part : level.parts)
        if (!level.active[part.node]) fail(CLQ_ARGUMENT, "a part hangs on node %u, which is deactivated", part.node);
    for (const PartSphere &sphere : level.part_spheres)
        if (!kept[sphere.entry])
            fail(CLQ_ARGUMENT, "a part's sphere follows matrix %u, which its level does not ask for", sphere.entry);
}

void check_nodes(const Template &tmpl, const Level &level)
{
    const Rig &rig = tmpl.rig;
    require_count(level.active.size(), rig.node_count(), "active nodes");
    size_t kept = 0;
    for (uint32_t i = 0; i < rig.node_count(); ++i) {
        if (level.active[i] > 1) fail(CLQ_ARGUMENT, "node %u is active %u times", i, unsigned(level.active[i]));
        if (!level.active[i]) continue;
        if (rig.parents[i] != none && !level.active[rig.parents[i]])
            fail(CLQ_ARGUMENT, "node %u is active below node %u, which is not", i, rig.parents[i]);
        if (kept >= level.nodes.size() || level.nodes[kept] != i)
            fail(CLQ_ARGUMENT, "active node %u is not in the list of nodes", i);
        ++kept;
    }
    require_count(level.nodes.size(), kept, "nodes of a level");
}

}  // namespace

void check_skeleton(const Template &tmpl, size_t index)
{
    const Level &level = tmpl.levels[index];
    if (level.skeletal_level > index || tmpl.levels[level.skeletal_level].skeletal_level != level.skeletal_level)
        fail(CLQ_ARGUMENT, "level %zu shares poses with level %u", index, level.skeletal_level);
    const Level &first = tmpl.levels[level.skeletal_level];
    if (level.active != first.active || level.nodes != first.nodes || level.entries != first.entries)
        fail(CLQ_ARGUMENT, "levels %zu and %u share poses and have different skeletons", index, level.skeletal_level);
    if (index > 0 && level.active == tmpl.levels[index - 1].active &&
        level.skeletal_level != tmpl.levels[index - 1].skeletal_level)
        fail(CLQ_ARGUMENT, "levels %zu and %zu have one skeleton and do not share poses", index - 1, index);
    if (level.active.empty()) {
        require_count(level.nodes.size() + level.entries.size(), 0, "nodes and matrices of a whole skeleton");
        return;
    }
    check_nodes(tmpl, level);
    check_entries(tmpl, level);
}

void check_parts(const Template &tmpl, const Level &level)
{
    if (level.parts.size() > max_level_parts)
        fail(CLQ_ARGUMENT, "a level of %zu parts: %u are the most", level.parts.size(), max_level_parts);
    uint64_t triangles = 0;
    for (const LevelPart &part : level.parts) triangles += part.triangles;
    require_count(triangles, triangles_of(level), "triangles of all parts");
    for (size_t p = 0; p < level.parts.size(); ++p) check_part(tmpl, level, p);
    for (const PartSphere &sphere : level.part_spheres) check_sphere(tmpl, sphere);
}

void check_part_firsts(const Level &level)
{
    const size_t parts = level.parts.size();
    std::vector<uint64_t> triangles(parts);
    for (const Surface &surface : level.surfaces) {
        if (parts < 2) {
            require_count(surface.part_offsets.size(), 0, "offsets of parts where there is one");
            continue;
        }
        const size_t ranges = surface.clean.size() + surface.dirty_by_zone.size() + 2;
        require_count(surface.part_offsets.size(), ranges * (parts + 1), "offsets of parts");
        const uint32_t *firsts = surface.part_offsets.data();
        const auto next = [&](uint32_t count, std::vector<uint64_t> *sums) {
            check_firsts(firsts, parts, count, sums);
            firsts += parts + 1;
        };
        for (const Bin &bin : surface.clean) next(bin.range.count, &triangles);
        next(surface.dirty.count, &triangles);
        for (const Bin &bin : surface.dirty_by_zone) next(bin.range.count, nullptr);
        next(surface.fused.count, nullptr);
    }
    for (size_t p = 0; p < parts && parts > 1; ++p)
        if (triangles[p] != level.parts[p].triangles)
            fail(CLQ_ARGUMENT, "part %zu has %u triangles, its ranges %llu", p, level.parts[p].triangles,
                 static_cast<unsigned long long>(triangles[p]));
}

}  // namespace claque::model
