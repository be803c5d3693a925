// The fields of a template in file order. Writing and reading use this one list, so that they cannot differ. An Archive
// has value() for numbers, flag(), text(), and array() and rows() with the smallest size of an element in the file.
// Tmpl is Template or const Template.
#pragma once

#include "lib/model/template.h"

namespace claque::model
{

template <class Archive, class R>
void walk_rig(Archive &a, R &rig)
{
    a.array(rig.parents, 4, [&](auto &v) { a.value(v); });
    a.array(rig.rest, 40, [&](auto &trs) {
        for (int k = 0; k < 3; ++k) a.value(trs.translation[k]);
        a.value(trs.rotation.x), a.value(trs.rotation.y), a.value(trs.rotation.z), a.value(trs.rotation.w);
        for (int k = 0; k < 3; ++k) a.value(trs.scale[k]);
    });
    a.array(rig.node_names, 8, [&](auto &name) { a.text(name); });
    a.array(rig.palette, 52, [&](auto &entry) {
        a.value(entry.node);
        for (auto &c : entry.inverse_bind.c) a.value(c);
    });
    a.array(rig.morph_sets, 12,
            [&](auto &set) { a.value(set.node), a.value(set.first_weight), a.value(set.target_count); });
    a.array(rig.rest_weights, 4, [&](auto &v) { a.value(v); });
    a.array(rig.clips, 16, [&](auto &clip) {
        a.value(clip.first_channel), a.value(clip.channel_count), a.value(clip.start_s), a.value(clip.duration_s);
    });
    a.array(rig.clip_names, 8, [&](auto &name) { a.text(name); });
    a.array(rig.channels, 20, [&](auto &channel) {
        a.value(channel.node), a.value(channel.target), a.value(channel.interpolation);
        a.value(channel.component_count);
        a.value(channel.first_time), a.value(channel.key_count), a.value(channel.first_value);
    });
    a.array(rig.times, 4, [&](auto &v) { a.value(v); });
    a.array(rig.values, 4, [&](auto &v) { a.value(v); });
    a.array(rig.deactivation_m, 4, [&](auto &v) { a.value(v); });
    a.array(rig.dofs, 33, [&](auto &dof) {
        a.value(dof.node), a.value(dof.kind), a.value(dof.morph_target);
        for (int k = 0; k < 3; ++k) a.value(dof.axis[k]);
        a.value(dof.min), a.value(dof.max), a.value(dof.rest);
    });
    a.array(rig.dof_names, 8, [&](auto &name) { a.text(name); });
    a.array(rig.markers, 8, [&](auto &marker) { a.value(marker.clip), a.value(marker.time_s); });
    a.array(rig.marker_names, 8, [&](auto &name) { a.text(name); });
    a.array(rig.root_curves, 12,
            [&](auto &curve) { a.value(curve.clip), a.value(curve.first_sample), a.value(curve.sample_count); });
    a.array(rig.root_samples, 4, [&](auto &v) { a.value(v); });
}

template <class Archive, class Range>
void walk_range(Archive &a, Range &range)
{
    a.value(range.first), a.value(range.count);
}

template <class Archive, class S>
void walk_sphere(Archive &a, S &sphere)
{
    for (int k = 0; k < 3; ++k) a.value(sphere.centre[k]);
    a.value(sphere.radius);
}

template <class Archive, class S>
void walk_surface(Archive &a, S &surface)
{
    const auto bin = [&](auto &b) { a.value(b.zone_index), walk_range(a, b.range); };
    a.value(surface.texture), a.flag(surface.double_sided), a.flag(surface.lighting.unlit);
    for (auto &v : surface.lighting.emission) a.value(v);
    a.array(surface.clean, 12, bin);
    walk_range(a, surface.dirty);
    a.array(surface.dirty_by_zone, 12, bin);
    walk_range(a, surface.fused);
    a.array(surface.part_offsets, 4, [&](auto &v) { a.value(v); });
}

template <class Archive, class L>
void walk_level(Archive &a, L &level)
{
    const auto number = [&](auto &v) { a.value(v); };
    a.value(level.source_count), a.value(level.vertex_count);
    a.array(level.positions, 4, number);
    a.array(level.normals, 4, number);
    a.array(level.runs, 16, [&](auto &run) {
        a.value(run.first), a.value(run.count), a.value(run.influences), a.value(run.first_influence);
    });
    a.array(level.joints, 2, number);
    a.array(level.weights, 4, number);
    a.array(level.morph_deltas, 28, [&](auto &delta) {
        a.value(delta.vertex);
        for (auto &v : delta.position) a.value(v);
        for (auto &v : delta.normal) a.value(v);
    });
    a.array(level.morph_ranges, 12,
            [&](auto &range) { a.value(range.weight), a.value(range.first), a.value(range.count); });
    a.array(level.copies, 4, number);
    a.array(level.uvs, 4, number);
    a.array(level.colours, 1, number);
    a.array(level.slots, 2, number);
    a.array(level.indices, 4, number);
    a.rows(level.surfaces, 58, [&](auto &surface) { walk_surface(a, surface); });
    a.value(level.switch_distance_m);
    a.value(level.skeletal_level);
    a.array(level.active, 1, number);
    a.array(level.nodes, 4, number);
    a.array(level.entries, 4, number);
    a.array(level.parts, 16, [&](auto &part) {
        a.value(part.node), a.value(part.first_sphere), a.value(part.sphere_count), a.value(part.triangles);
    });
    a.array(level.part_spheres, 20, [&](auto &sphere) { a.value(sphere.entry), walk_sphere(a, sphere.bind); });
}

template <class Archive, class T>
void walk_texture(Archive &a, T &texture)
{
    a.value(texture.width), a.value(texture.height), a.value(texture.wrap_s), a.value(texture.wrap_t);
    a.array(texture.rgba, 1, [&](auto &v) { a.value(v); });
    a.array(texture.keys, 5, [&](auto &key) { a.value(key.zone), a.value(key.key); });
    a.flag(texture.has_holes);
    a.rows(texture.set_images, 12, [&](auto &image) {
        a.value(image.width), a.value(image.height);
        a.array(image.rgba, 1, [&](auto &v) { a.value(v); });
    });
}

// Members computed by derive() are not stored.
template <class Archive, class M>
void walk_motion(Archive &a, M &motion)
{
    a.array(motion.nodes, 4, [&](auto &v) { a.value(v); });
    a.array(motion.groups, 9, [&](auto &group) { a.value(group.target), a.value(group.index), a.value(group.count); });
    a.array(motion.clips, 24, [&](auto &clip) {
        a.value(clip.intervals), a.value(clip.rate_hz), a.value(clip.first_exact), a.value(clip.exact_count);
        a.value(clip.error_m), a.value(clip.error_rad);
    });
    a.array(motion.blocks, 12, [&](auto &block) { a.value(block.first), a.value(block.stride), a.value(block.moved); });
    a.array(motion.curves, 40, [&](auto &curve) {
        a.value(curve.first), a.value(curve.stride);
        for (auto &v : curve.min) a.value(v);
        for (auto &v : curve.step) a.value(v);
    });
    a.array(motion.exact, 8, [&](auto &exact) { a.value(exact.channel), a.value(exact.index); });
    a.array(motion.rotations, 2, [&](auto &v) { a.value(v); });
    a.array(motion.numbers, 2, [&](auto &v) { a.value(v); });
}

template <class Archive, class Tmpl>
void walk_template(Archive &a, Tmpl &tmpl)
{
    a.text(tmpl.name);
    walk_rig(a, tmpl.rig);
    walk_motion(a, tmpl.motion);
    a.flag(tmpl.similar_only);
    a.array(tmpl.zone_names, 8, [&](auto &name) { a.text(name); });
    a.array(tmpl.zone_colours, 12, [&](auto &colour) {
        for (auto &v : colour) a.value(v);
    });
    a.array(tmpl.zone_ranges, 24, [&](auto &range) {
        a.value(range.hue_min_deg), a.value(range.hue_max_deg);
        a.value(range.saturation_min), a.value(range.saturation_max);
        a.value(range.brightness_min), a.value(range.brightness_max);
    });
    a.array(tmpl.zone_clean, 4, [&](auto &v) { a.value(v); });
    a.array(tmpl.texture_sets, 8, [&](auto &name) { a.text(name); });
    a.rows(tmpl.textures, 31, [&](auto &texture) { walk_texture(a, texture); });
    a.rows(tmpl.levels, 160, [&](auto &level) { walk_level(a, level); });
    walk_sphere(a, tmpl.sklsroot);
    a.array(tmpl.node_reach, 8, [&](auto &reach) { a.value(reach.distance), a.value(reach.scale); });
    const auto by_added = [&](auto &bound) { a.value(bound.base), a.value(bound.per_weight); };
    by_added(tmpl.blend_radius);
    a.array(tmpl.blend_reach, 16, [&](auto &reach) { by_added(reach.distance), by_added(reach.scale); });
    auto &r = tmpl.report;
    a.value(r.triangles), a.value(r.degenerate), a.value(r.dirty), a.value(r.dirty_zone_sum), a.value(r.coincident);
    a.value(r.fused_triangles), a.value(r.copies);
}

}  // namespace claque::model
