// Builds the draw list of each view: its individuals, sorted.
#include <algorithm>

#include "lib/frame/order.h"
#include "lib/frame/steps.h"
#include "lib/math/eye_transform.h"

namespace claque::frame
{

draw::Item ListView::item_of(const SortEntry &entry) const
{
    const crowd::Crowd &crowd = given.crowd;
    const CameraState &eye = given.eyes[view_index];
    const animcache::Request &request = caches.requests()[entry.candidate];
    const crowd::Transform &transform = candidates[entry.candidate].root;
    const ViewVisibility &visibility = visibilities.at(view_index, entry.candidate);
    draw::Item item;
    item.tmpl = &crowd.template_of(entry.row);
    item.level = request.level;
    item.actor_index = entry.row;
    item.texture_set = entry.texture_set;
    item.generation = crowd.actor(entry.row).generation;
    item.request = entry.candidate;
    item.parts = visibility.parts;
    item.shadow_only = visibility.shadow_only;
    item.locals = caches.locals_of(request);
    if (!item.locals) item.vertices = caches.vertices_of(request);
    item.pose = caches.pose_of(request);
    item.zone_rgb = crowd.zone_rgb(entry.row);
    math::store_matrix(math::eye_transform(eye.world_to_eye, eye.eye, transform.position, transform.orientation,
                                           double(transform.scale)),
                       item.model_view);
    item.eye_distance_m = entry.distance * given.settings.caches.metres_per_unit;
    item.mirrored = transform.scale < 0;
    const bool placed = crowd.follows().of(entry.row) && !crowd.behaviours().has_root_path_play(entry.row);
    const glm::dvec3 ground = placed || follows_ground(crowd, entry.row)
                                  ? transform.position
                                  : crowd::reference_position_of(crowd, entry.row, given.time_s);
    for (int k = 0; k < 3; ++k) item.ground[k] = ground[k];
    return item;
}

namespace
{

size_t colour_bytes(const draw::Item &item) { return item.zone_rgb ? 3 * size_t(item.tmpl->zone_count()) : 0; }

// Within the capacity that reserve() made.
void make_room_for_colours(View &view, size_t bytes)
{
    if (view.grown.capacity() > view.colours.capacity()) {
        view.colours.swap(view.grown);
        model::Array<uint8_t>(view.grown.get_allocator()).swap(view.grown);
    }
    view.colours.resize(bytes);
}

int32_t call_before(void *user, uint32_t index1, uint32_t generation)
{
    const clq_actor_hooks &host = static_cast<const Hooked *>(user)->host;
    return host.before(host.user, clq_actor{index1, generation});
}

void call_after(void *user, uint32_t index1, uint32_t generation)
{
    const clq_actor_hooks &host = static_cast<const Hooked *>(user)->host;
    host.after(host.user, clq_actor{index1, generation});
}

// Within the capacity that reserve() made.
void keep_hooks(const crowd::Crowd &crowd, View &view)
{
    view.hooked.clear();
    if (crowd.hooked_count() == 0) return;
    for (draw::Item &item : view.list.items) {
        const crowd::Extra *extra = crowd.extra_of(item.actor_index);
        if (!extra || (!extra->hooks.before && !extra->hooks.after)) continue;
        view.hooked.push_back(Hooked{extra->hooks, {}});
        Hooked &hooked = view.hooked.back();
        if (extra->hooks.before) hooked.hooks.before = call_before;
        if (extra->hooks.after) hooked.hooks.after = call_after;
        hooked.hooks.user = &hooked;
        item.hooks = &hooked.hooks;
    }
}

}  // namespace

base::Status ListView::check() const
{
    if (view_index >= given.eyes.count)
        return base::Status::bad(CLQ_ARGUMENT, "view %u of %u", view_index, given.eyes.count);
    if (caches.requests().count != candidates.count || visibilities.candidates != candidates.count)
        return base::Status::bad(CLQ_ARGUMENT, "no request or no visibility of every candidate");
    if (std::min({listed.capacity(), ordered.capacity(), view.list.items.capacity()}) < visible.count)
        return base::Status::bad(CLQ_ARGUMENT, "no room for %u visible individuals", visible.count);
    return base::Status::good();
}

void ListView::run() const
{
    const crowd::Crowd &crowd = given.crowd;
    listed.clear();
    for (const uint32_t i : visible) {
        const uint32_t row = candidates[i].row;
        const ViewVisibility &visibility = visibilities.at(view_index, i);
        if (visibility.inside != math::Containment::outside)
            listed.push_back({crowd.actor(row).tmpl, crowd.actor(row).texture_set, visibility.distance, row, i});
    }
    sort_entries(listed, ordered);

    view.list.items.resize(listed.size());
    std::copy(std::begin(view.camera.projection), std::end(view.camera.projection), view.list.projection);
    const CameraState &eye = given.eyes[view_index];
    for (int k = 0; k < 3; ++k) view.list.eye[k] = eye.eye[k];
    for (int k = 0; k < 9; ++k) view.list.world_to_eye[k] = eye.world_to_eye[k / 3][k % 3];
    view.list.distance_scale = static_cast<float>(eye.distance_scale);
    view.list.min_distance_m = static_cast<float>(eye.min_distance * double(given.settings.caches.metres_per_unit));
    write_items();
    keep_hooks(crowd, view);
}

// The items, and copies of their colours one after the other.
void ListView::write_items() const
{
    const uint32_t count = static_cast<uint32_t>(listed.size());
    draw::Item *items = view.list.items.data();
    size_t offsets[Given::part_count + 1] = {0};
    given.for_parts(count, [&](uint32_t part, uint32_t first, uint32_t last) {
        size_t bytes = 0;
        for (uint32_t i = first; i < last; ++i) {
            items[i] = item_of(listed[i]);
            bytes += colour_bytes(items[i]);
        }
        offsets[part + 1] = bytes;
    });
    for (uint32_t part = 0; part < Given::part_count; ++part) offsets[part + 1] += offsets[part];
    make_room_for_colours(view, offsets[Given::part_count]);
    given.for_parts(count, [&](uint32_t part, uint32_t first, uint32_t last) {
        uint8_t *to = view.colours.data() + offsets[part];
        for (uint32_t i = first; i < last; ++i) {
            if (!items[i].zone_rgb) continue;
            uint8_t *end = std::copy_n(items[i].zone_rgb, colour_bytes(items[i]), to);
            items[i].zone_rgb = to;
            to = end;
        }
    });
}

}  // namespace claque::frame
