// What a template holds, and templates as prepared files.
#include <claque/template_info.h>

#include <algorithm>
#include <array>

#include "lib/api/boundary.h"
#include "lib/api/handles.h"
#include "lib/api/template_def.h"
#include "lib/model/template_file.h"
#include "meshsplit/picture.h"

using namespace claque;

namespace
{

uint64_t bytes_of(const model::Template &t)
{
    const auto size = [](const auto &array) { return array.size() * sizeof(array[0]); };
    const model::Rig &rig = t.rig;
    uint64_t bytes = sizeof(clq_template) + size(rig.parents) + size(rig.rest) + size(rig.palette) +
                     size(rig.channels) + size(rig.times) + size(rig.values) + size(rig.clips) + size(rig.rest_weights);
    bytes += model::motion_bytes(t.motion);
    for (const model::Texture &texture : t.textures) {
        bytes += sizeof texture + size(texture.rgba) + size(texture.keys);
        for (const model::TextureImage &other : texture.set_images) bytes += sizeof other + size(other.rgba);
    }
    for (const model::Level &l : t.levels)
        bytes += sizeof l + size(l.positions) + size(l.normals) + size(l.runs) + size(l.joints) + size(l.weights) +
                 size(l.morph_deltas) + size(l.copies) + size(l.uvs) + size(l.colours) + size(l.slots) +
                 size(l.indices);
    return bytes;
}

uint32_t max_influences(const model::Level &level)
{
    uint32_t maximum = 0;
    for (const model::InfluenceRun &run : level.runs) maximum = run.influences > maximum ? run.influences : maximum;
    return maximum;
}

}  // namespace

void claque::api::log_report(clq_context *context, const model::Template &t)
{
    if (t.report.coincident)
        context->log.warn(
            base::text_of("template '%s': %u of %u triangles lie on another with the same corners; which of "
                          "them is seen depends on the order of drawing",
                          t.name.c_str(), t.report.coincident, t.report.triangles)
                .c_str());
    if (t.report.parts > model::max_level_parts)
        context->log.info(base::text_of("template '%s': a level has %u parts, and %u can be culled by themselves: "
                                        "neighbours are culled as one",
                                        t.name.c_str(), t.report.parts, model::max_level_parts)
                              .c_str());
}

extern "C" {

void clq_template_destroy(clq_template *tmpl)
{
    if (tmpl) api::release(tmpl);
}

clq_status clq_template_save(const clq_template *tmpl, clq_write_function write, void *user)
{
    return api::boundary("clq_template_save", [&] {
        api::require(tmpl && write, "tmpl or write is NULL");
        std::pmr::vector<uint8_t> bytes(&tmpl->context->memory);
        // The writer may release the template.
        const std::string name = tmpl->name.c_str();
        model::save(*tmpl, bytes);
        if (!api::host_takes(write, user, bytes.data(), bytes.size()))
            base::fail(CLQ_IO, "the writer refused %zu bytes of template '%s'", bytes.size(), name.c_str());
    });
}

clq_status clq_template_load(clq_context *context, const void *bytes, size_t size_bytes, clq_template **out)
{
    return api::boundary("clq_template_load", [&] {
        api::require(context && bytes && out, "context, bytes or out is NULL");
        api::Making<clq_template> made(context, context);
        model::load(static_cast<const uint8_t *>(bytes), size_bytes, *made);
        api::log_report(context, *made);
        *out = made.release();
    });
}

clq_status clq_template_get_info(const clq_template *tmpl, clq_template_info *out)
{
    return api::boundary("clq_template_get_info", [&] {
        api::require(tmpl && out, "tmpl or out is NULL");
        api::require_size(*out, "clq_template_info_init");
        const model::Level &level = tmpl->levels[0];
        const model::SplitReport &report = tmpl->report;
        clq_template_info info = clq_template_info_init();
        info.name = tmpl->name.c_str();
        info.node_count = tmpl->rig.node_count();
        info.joint_count = static_cast<uint32_t>(tmpl->rig.palette.size());
        info.clip_count = static_cast<uint32_t>(tmpl->rig.clips.size());
        info.zone_count = tmpl->zone_count();
        info.texture_count = static_cast<uint32_t>(tmpl->textures.size());
        info.surface_count = static_cast<uint32_t>(level.surfaces.size());
        info.vertex_count = level.source_count;
        info.fused_vertex_count = level.vertex_count;
        info.triangle_count = report.triangles;
        info.dirty_count = report.dirty;
        info.clean_count = report.triangles - report.dirty;
        info.coincident_count = report.coincident;
        info.fused_triangle_count = report.fused_triangles;
        info.dirty_zone_mean =
            report.dirty ? static_cast<float>(report.dirty_zone_sum) / static_cast<float>(report.dirty) : 0;
        info.max_influences = max_influences(level);
        for (int k = 0; k < 3; ++k) info.sklsroot_centre[k] = tmpl->sklsroot.centre[k];
        info.sklsroot_radius = tmpl->sklsroot.radius;
        info.dof_count = static_cast<uint32_t>(tmpl->rig.dofs.size());
        info.level_count = static_cast<uint32_t>(tmpl->levels.size());
        info.part_count = static_cast<uint32_t>(level.parts.size());
        info.marker_count = static_cast<uint32_t>(tmpl->rig.markers.size());
        info.texture_set_count = tmpl->texture_set_count();
        info.bytes = bytes_of(*tmpl);
        api::write_out(out, info);
    });
}

clq_status clq_template_get_clip(const clq_template *tmpl, uint32_t clip, clq_clip_info *out)
{
    return api::boundary("clq_template_get_clip", [&] {
        api::require(tmpl && out, "tmpl or out is NULL");
        api::require_size(*out, "clq_clip_info_init");
        if (clip >= tmpl->rig.clips.size())
            base::fail(CLQ_ARGUMENT, "clip %u does not exist: '%s' has %zu", clip, tmpl->name.c_str(),
                       tmpl->rig.clips.size());
        const model::Clip &found = tmpl->rig.clips[clip];
        clq_clip_info info = clq_clip_info_init();
        info.name = tmpl->rig.clip_names[clip].c_str();
        info.start_s = found.start_s, info.duration_s = found.duration_s;
        info.channel_count = found.channel_count;
        if (!tmpl->motion.empty()) {
            const model::MotionClip &sampled = tmpl->motion.clips[clip];
            info.rate_hz = sampled.rate_hz;
            info.error = sampled.error_m, info.error_rad = sampled.error_rad;
            info.kept_count = sampled.exact_count;
            info.bytes = model::motion_bytes(tmpl->motion, tmpl->rig, clip);
        }
        api::write_out(out, info);
    });
}

clq_status clq_template_get_marker(const clq_template *tmpl, uint32_t marker, clq_marker_info *out)
{
    return api::boundary("clq_template_get_marker", [&] {
        api::require(tmpl && out, "tmpl or out is NULL");
        api::require_size(*out, "clq_marker_info_init");
        const model::Rig &rig = tmpl->rig;
        if (marker >= rig.markers.size())
            base::fail(CLQ_ARGUMENT, "marker %u does not exist: '%s' has %zu", marker, tmpl->name.c_str(),
                       rig.markers.size());
        clq_marker_info info = clq_marker_info_init();
        info.name = rig.marker_names[marker].c_str();
        info.clip = rig.markers[marker].clip, info.time_s = rig.markers[marker].time_s;
        api::write_out(out, info);
    });
}

clq_status clq_template_get_zone(const clq_template *tmpl, uint32_t zone, clq_zone_info *out)
{
    return api::boundary("clq_template_get_zone", [&] {
        api::require(tmpl && out, "tmpl or out is NULL");
        api::require_size(*out, "clq_zone_info_init");
        if (zone >= tmpl->zone_count())
            base::fail(CLQ_ARGUMENT, "zone %u does not exist: '%s' has %u", zone, tmpl->name.c_str(),
                       tmpl->zone_count());
        clq_zone_info info = clq_zone_info_init();
        info.name = tmpl->zone_names[zone].c_str();
        for (size_t k = 0; k < 3; ++k) info.colour[k] = tmpl->zone_colours[zone][k];
        info.range = api::range_of(tmpl->zone_ranges[zone]);
        info.clean_count = zone < tmpl->zone_clean.size() ? tmpl->zone_clean[zone] : 0;
        api::write_out(out, info);
    });
}

clq_status clq_template_get_dof(const clq_template *tmpl, uint32_t dof, clq_dof_info *out)
{
    return api::boundary("clq_template_get_dof", [&] {
        api::require(tmpl && out, "tmpl or out is NULL");
        api::require_size(*out, "clq_dof_info_init");
        const model::Rig &rig = tmpl->rig;
        if (dof >= rig.dofs.size())
            base::fail(CLQ_ARGUMENT, "degree of freedom %u does not exist: there are %zu in template '%s'", dof,
                       rig.dofs.size(), tmpl->name.c_str());
        const model::Dof &d = rig.dofs[dof];
        const uint32_t node = d.kind == model::DofKind::morph ? rig.morph_sets[d.node].node : d.node;
        clq_dof_info info = clq_dof_info_init();
        info.name = rig.dof_names[dof].c_str();
        info.node = node;
        info.kind = static_cast<clq_dof_kind>(d.kind);
        info.min = d.min, info.max = d.max, info.rest = d.rest;
        api::write_out(out, info);
    });
}

clq_status clq_template_get_level(const clq_template *tmpl, uint32_t level, clq_level_info *out)
{
    return api::boundary("clq_template_get_level", [&] {
        api::require(tmpl && out, "tmpl or out is NULL");
        api::require_size(*out, "clq_level_info_init");
        if (level >= tmpl->levels.size())
            base::fail(CLQ_ARGUMENT, "level %u does not exist: there are %zu in template '%s'", level,
                       tmpl->levels.size(), tmpl->name.c_str());
        const model::Level &l = tmpl->levels[level];
        clq_level_info info = clq_level_info_init();
        info.lod_min_m = l.switch_distance_m;
        for (const model::Surface &surface : l.surfaces) {
            info.triangle_count += surface.dirty.count / 3;
            for (const model::Bin &bin : surface.clean) info.triangle_count += bin.range.count / 3;
        }
        info.vertex_count = l.source_count;
        info.part_count = static_cast<uint32_t>(l.parts.size());
        info.node_count = l.active.empty() ? tmpl->rig.node_count() : static_cast<uint32_t>(l.nodes.size());
        api::write_out(out, info);
    });
}

uint32_t clq_template_find_dof(const clq_template *tmpl, const char *name)
{
    return tmpl && name ? tmpl->rig.find_dof(name) : CLQ_NONE;
}

uint32_t clq_template_find_clip(const clq_template *tmpl, const char *name)
{
    return tmpl && name ? tmpl->rig.find_clip(name) : CLQ_NONE;
}

const char *clq_template_get_node_name(const clq_template *tmpl, uint32_t node)
{
    return tmpl && node < tmpl->rig.node_names.size() ? tmpl->rig.node_names[node].c_str() : "";
}

uint32_t clq_template_find_node(const clq_template *tmpl, const char *name)
{
    return tmpl && name ? tmpl->rig.find_node(name) : CLQ_NONE;
}

uint32_t clq_template_find_zone(const clq_template *tmpl, const char *name)
{
    if (tmpl && name)
        for (uint32_t i = 0; i < tmpl->zone_count(); ++i)
            if (std::string_view(tmpl->zone_names[i]) == name) return i;
    return CLQ_NONE;
}

clq_status clq_template_get_split_picture(const clq_template *tmpl, uint32_t texture, uint32_t scale, clq_picture *out)
{
    return api::boundary("clq_template_get_split_picture", [&] {
        api::require(tmpl && out, "tmpl or out is NULL");
        clq_picture picture = api::read_def(out, clq_picture_init, "clq_picture_init");
        api::require(scale >= 1 && scale <= 16, "scale is not 1 to 16");
        if (texture >= tmpl->textures.size())
            base::fail(CLQ_ARGUMENT, "texture %u does not exist: '%s' has %zu", texture, tmpl->name.c_str(),
                       tmpl->textures.size());
        const uint32_t width = tmpl->textures[texture].width * scale, height = tmpl->textures[texture].height * scale;
        if (picture.pixels) {
            const size_t pixels = static_cast<size_t>(width) * height;
            if (picture.capacity_bytes < 3 * pixels)
                base::fail(CLQ_ARGUMENT, "%zu bytes for a picture of %u x %u, which takes %zu", picture.capacity_bytes,
                           width, height, 3 * pixels);
            const std::vector<uint8_t> rgba = meshsplit::split_picture(*tmpl, texture, static_cast<int>(scale));
            for (size_t i = 0; i < pixels; ++i)
                for (size_t k = 0; k < 3; ++k) picture.pixels[3 * i + k] = rgba[4 * i + k];
        }
        picture.width_px = width, picture.height_px = height;
        api::write_out(out, picture);
    });
}

}  // extern "C"
