// Prepared files for tests: their content, and every reader of it, so that a sanitizer detects the effects of a bad
// file.
#pragma once

#include <gtest/gtest.h>

#include "articulated.h"
#include "lib/base/hash.h"
#include "lib/model/template_check.h"
#include "lib/model/template_file.h"
#include "meshsplit/picture.h"
#include "meshsplit/vertex_cloud.h"

namespace claque::test
{

using Bytes = std::pmr::vector<uint8_t>;

// Five levels: the fourth shares poses with the third, and the last is empty; several parts, two surfaces, dirty
// triangles.
inline model::Model puppet_in_levels()
{
    Puppet m;
    m.skin({m.root, m.spine, m.arm, m.hand, m.finger}, "body", 0, 90);
    m.hang(m.hand, "glove", 0, 40);
    m.hang(m.root, "stump", 40, 90);
    m.hang(m.leg, "shoe", 0, 60);
    const model::Model looks = torture(3, 0, 40);
    m.images = {key_image(4, 4, [](uint32_t x, uint32_t y) { return uint8_t((x + y) % 3 * 40); })};
    m.zones = looks.zones;
    m.materials.assign(2, looks.materials[0]);
    m.materials[1].double_sided = true;
    m.materials[1].lighting.emission = {0.1f, 0.2f, 1};
    for (size_t p = 0; p < m.parts.size(); ++p) m.parts[p].material = p % 2;
    m.stop(m.finger, 20);
    m.stop(m.hand, 40);
    return static_cast<model::Model &&>(m);
}

inline Bytes saved(const model::Template &tmpl)
{
    Bytes bytes;
    model::save(tmpl, bytes);
    return bytes;
}

// Reads the data of part culling and of reduced skeletons.
inline double use_parts(const model::Template &tmpl, const model::Level &level)
{
    double sum = 0;
    for (const uint32_t node : level.nodes) sum += double(tmpl.rig.rest[node].scale.x) + level.active[node];
    for (const uint32_t entry : level.entries) sum += tmpl.rig.palette[entry].node;
    for (const model::LevelPart &part : level.parts) {
        sum += double(tmpl.rig.rest[part.node].scale.x);
        for (uint32_t i = 0; i < part.sphere_count; ++i) {
            const model::PartSphere &sphere = level.part_spheres[part.first_sphere + i];
            sum += double(sphere.bind.radius) + double(tmpl.rig.palette[sphere.entry].inverse_bind.c[0]);
        }
    }
    for (const model::Surface &surface : level.surfaces) {
        const uint32_t *firsts = surface.part_offsets.data();
        if (level.parts.size() < 2) continue;
        const auto read = [&](model::IndexRange range) {
            for (size_t p = 0; p < level.parts.size(); ++p)
                for (uint32_t i = firsts[p]; i < firsts[p + 1]; ++i) sum += level.indices[range.first + i];
            firsts += level.parts.size() + 1;
        };
        for (const model::Bin &bin : surface.clean) read(bin.range);
        read(surface.dirty);
        for (const model::Bin &bin : surface.dirty_by_zone) read(bin.range);
        read(surface.fused);
    }
    return sum;
}

// Reads all data of posing, skinning and drawing; a sanitizer or a crash reports an index out of range.
inline double use(const model::Template &tmpl)
{
    double sum = 0;
    pose::Workspace workspace(tmpl.rig);
    for (uint32_t clip = 0; clip <= tmpl.rig.clips.size(); ++clip)
        for (const double time : {0.0, 0.3, 7.0}) {
            const auto palette = workspace.pose(clip < tmpl.rig.clips.size() ? clip : model::none, time);
            for (const model::Level &level : tmpl.levels) {
                const meshsplit::VertexCloud cloud(level, tmpl.rig);
                for (uint32_t v = 0; v < level.source_count; ++v)
                    sum += double(cloud.skinned(v, palette.data, workspace.weights().data).x);
            }
        }
    for (uint32_t texture = 0; texture < tmpl.textures.size(); ++texture)
        sum += meshsplit::split_picture(tmpl, texture, 1)[0];
    for (const model::Level &level : tmpl.levels)
        for (const model::Surface &surface : level.surfaces)
            for (uint32_t i = 0; i < surface.fused.count; ++i) {
                const uint32_t v = level.indices[surface.fused.first + i];
                const uint32_t source = v < level.source_count ? v : level.copies[v - level.source_count];
                sum += double(level.positions[3 * source]) + double(level.uvs[2 * v]);
                sum += tmpl.textures[surface.texture].keys[level.slots[v] / 2].key;
                if (!level.colours.empty()) sum += level.colours[4 * v];
            }
    for (const model::Level &level : tmpl.levels) sum += use_parts(tmpl, level);
    for (const model::Texture &texture : tmpl.textures)
        for (const model::ZoneKey &key : texture.keys) sum += double(tmpl.zone_colours[key.zone][0]);
    return sum;
}

// CLQ_OK, or the reason of the refusal.
inline clq_status outcome(const Bytes &bytes)
{
    model::Template out(std::pmr::get_default_resource());
    try {
        model::load(bytes.data(), bytes.size(), out);
    } catch (const base::Error &error) {
        return error.status();
    }
    volatile const double read = use(out);
    (void)read;
    return CLQ_OK;
}

inline void forge_hash(Bytes &bytes)
{
    const uint64_t hash = base::fnv(base::fnv_start, bytes.data() + 32, bytes.size() - 32);
    for (size_t i = 0; i < 8; ++i) bytes[24 + i] = uint8_t(hash >> (8 * i));
}

}  // namespace claque::test
