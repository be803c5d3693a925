// What the draw list of a view holds, as numbers.
#include <claque/drawn_actor.h>

#include <algorithm>

#include "lib/api/boundary.h"
#include "lib/api/inspected.h"

using namespace claque;

namespace
{

const draw::Item &item_of(const clq_view *view, uint32_t index)
{
    const draw::DrawList &list = view->view.list;
    if (index >= list.items.size())
        base::fail(CLQ_ARGUMENT, "individual %u does not exist: the draw list has %zu", index, list.items.size());
    return list.items[index];
}

void require_room(uint32_t capacity, size_t wanted, const char *what)
{
    if (capacity < wanted) base::fail(CLQ_ARGUMENT, "room for %u %s, of which there are %zu", capacity, what, wanted);
}

// The draw list has no pose for parts that GL's matrix stack places.
draw::Pose pose_of(api::Inspected &inspected, const draw::Item &item)
{
    const draw::Pose pose = inspected.pose(item);
    if (!pose.palette)
        base::fail(CLQ_ARGUMENT, "actor %u shows two key-poses blended, vertex by vertex: it has no palette",
                   item.actor_index + 1);
    return pose;
}

uint8_t byte_of(float colour) { return static_cast<uint8_t>(std::clamp(colour, 0.0f, 1.0f) * 255.0f + 0.5f); }

void write(const glm::vec3 &from, float *out) { out[0] = from.x, out[1] = from.y, out[2] = from.z; }

}  // namespace

extern "C" {

clq_status clq_view_get_drawn_actor(const clq_view *view, uint32_t index, clq_drawn_actor *out)
{
    return api::boundary("clq_view_get_drawn_actor", [&] {
        api::require(view && out, "view or out is NULL");
        api::require_size(*out, "clq_drawn_actor_init");
        const api::Drawing drawing(view);
        const draw::Item &item = item_of(view, index);
        clq_drawn_actor shown = clq_drawn_actor_init();
        shown.actor = {item.actor_index + 1, item.generation};
        shown.tmpl = static_cast<const clq_template *>(item.tmpl);
        shown.level = item.level;
        shown.texture_set = item.texture_set;
        std::copy(std::begin(item.model_view), std::end(item.model_view), shown.model_view);
        shown.eye_distance_m = item.eye_distance_m;
        shown.mirrored = item.mirrored;
        shown.shadow_only = item.shadow_only;
        shown.parts = item.parts;
        shown.vertex_count = item.tmpl->levels[item.level].source_count;
        shown.joint_count = static_cast<uint32_t>(item.tmpl->rig.palette.size());
        shown.morph_weight_count = static_cast<uint32_t>(item.tmpl->rig.rest_weights.size());
        shown.zone_count = item.tmpl->zone_count();
        api::write_out(out, shown);
    });
}

clq_status clq_view_get_arrays(const clq_view *view, uint32_t index, clq_drawn_arrays *out)
{
    return api::boundary("clq_view_get_arrays", [&] {
        api::require(view && out, "view or out is NULL");
        api::require_size(*out, "clq_drawn_arrays_init");
        const api::Drawing drawing(view);
        const draw::Item &item = item_of(view, index);
        clq_drawn_arrays held = clq_drawn_arrays_init();
        held.positions = item.vertices.positions;
        held.normals = item.vertices.normals;
        held.packed_positions = item.vertices.short_positions;
        held.packed_normals = item.vertices.byte_normals;
        std::copy(std::begin(item.vertices.offset), std::end(item.vertices.offset), held.packed_offset);
        held.packed_step = item.vertices.step;
        // Where nodes are deactivated, the entries that the level does not use are not set.
        const bool is_whole = item.tmpl->levels[item.level].active.empty();
        held.palette = item.pose.palette && is_whole ? item.pose.palette->c : nullptr;
        held.morph_weights = item.tmpl->rig.rest_weights.empty() ? nullptr : item.pose.weights;
        held.colours = item.zone_rgb;
        api::write_out(out, held);
    });
}

clq_status clq_view_get_colours(const clq_view *view, uint32_t index, uint8_t *out_rgb, uint32_t capacity_zones)
{
    return api::boundary("clq_view_get_colours", [&] {
        api::require(view && out_rgb, "view or out_rgb is NULL");
        const api::Drawing drawing(view);
        const draw::Item &item = item_of(view, index);
        require_room(capacity_zones, item.tmpl->zone_count(), "zones");
        if (item.zone_rgb) std::copy_n(item.zone_rgb, 3 * size_t(item.tmpl->zone_count()), out_rgb);
        else
            for (const std::array<float, 3> &colour : item.tmpl->zone_colours)
                for (const float c : colour) *out_rgb++ = byte_of(c);
    });
}

clq_status clq_view_get_vertices(const clq_view *view, uint32_t index, float *out_positions, float *out_normals,
                                 uint32_t capacity_vertices)
{
    return api::boundary("clq_view_get_vertices", [&] {
        api::require(view != nullptr, "view is NULL");
        const api::Drawing drawing(view);
        const draw::Item &item = item_of(view, index);
        const uint32_t count = item.tmpl->levels[item.level].source_count;
        require_room(capacity_vertices, count, "vertices");
        api::Inspected inspected(view);
        const draw::Vertices from = inspected.vertices(item);
        for (uint32_t v = 0; v < count; ++v) {
            if (out_positions) write(from.position(v), out_positions + 3 * size_t(v));
            if (out_normals) write(from.normal(v), out_normals + 3 * size_t(v));
        }
    });
}

clq_status clq_view_get_palette(const clq_view *view, uint32_t index, float *out_palette, uint32_t capacity_joints)
{
    return api::boundary("clq_view_get_palette", [&] {
        api::require(view && out_palette, "view or out_palette is NULL");
        const api::Drawing drawing(view);
        const draw::Item &item = item_of(view, index);
        const model::Rig &rig = item.tmpl->rig;
        require_room(capacity_joints, rig.palette.size(), "joints");
        api::Inspected inspected(view);
        const draw::Pose pose = pose_of(inspected, item);
        const model::Level &level = item.tmpl->levels[item.level];
        const auto copy = [&](size_t entry) { std::copy_n(pose.palette[entry].c, 12, out_palette + 12 * entry); };
        if (level.active.empty())
            for (size_t entry = 0; entry < rig.palette.size(); ++entry) copy(entry);
        else {
            const math::Affine identity;
            for (size_t entry = 0; entry < rig.palette.size(); ++entry)
                std::copy_n(identity.c, 12, out_palette + 12 * entry);
            for (const uint32_t entry : level.entries) copy(entry);
        }
    });
}

clq_status clq_view_get_morph_weights(const clq_view *view, uint32_t index, float *out_weights,
                                      uint32_t capacity_weights)
{
    return api::boundary("clq_view_get_morph_weights", [&] {
        api::require(view && (out_weights || capacity_weights == 0), "view or out_weights is NULL");
        const api::Drawing drawing(view);
        const draw::Item &item = item_of(view, index);
        const size_t count = item.tmpl->rig.rest_weights.size();
        require_room(capacity_weights, count, "morph weights");
        api::Inspected inspected(view);
        const draw::Pose pose = pose_of(inspected, item);
        if (count > 0) std::copy_n(pose.weights, count, out_weights);
    });
}

}  // extern "C"
