// The one thing that drawing sees: for each view its individuals, in their order.
#include <algorithm>

#include "lib/frame/order.h"
#include "lib/frame/steps.h"
#include "lib/math/eye_transform.h"

namespace claque::frame
{

draw::Item Update::item_of(const CameraState &eye, uint32_t view, const SortEntry &listed) const
{
    const Row &found = frame.rows_[listed.row];
    const crowd::Transform &transform = frame.candidates_[found.candidate].root;
    const ViewVisibility &visibility = view_visibility(view, found.candidate);
    draw::Item item;
    item.tmpl = &crowd.template_of(listed.row);
    item.level = found.visibility.level;
    item.actor_index = listed.row;
    item.texture_set = listed.texture_set;
    item.generation = crowd.actor(listed.row).generation;
    item.parts = visibility.parts;
    item.shadow_only = visibility.shadow_only;
    item.locals = frame.caches_.locals_of(listed.row);
    if (!item.locals) item.vertices = frame.caches_.vertices_of(listed.row);
    item.zone_rgb = crowd.zone_rgb(listed.row);
    math::store_matrix(math::eye_transform(eye.world_to_eye, eye.eye, transform.position, transform.orientation,
                                           double(transform.scale)),
                       item.model_view);
    item.eye_distance_m = listed.distance * frame.settings_.caches.metres_per_unit;
    item.mirrored = transform.scale < 0;
    const glm::dvec3 ground = follows_ground(listed.row) ? transform.position : position_of(listed.row);
    for (int k = 0; k < 3; ++k) item.ground[k] = ground[k];
    return item;
}

namespace
{

// Within what reserve() made room for: what is copied first does not move.
void keep_colours(View &view)
{
    if (view.grown.capacity() > view.colours.capacity()) {
        view.colours.swap(view.grown);
        model::Array<uint8_t>(view.grown.get_allocator()).swap(view.grown);
    }
    view.colours.clear();
    for (draw::Item &item : view.list.items) {
        if (!item.zone_rgb) continue;
        const size_t first = view.colours.size();
        view.colours.insert(view.colours.end(), item.zone_rgb, item.zone_rgb + 3 * size_t(item.tmpl->zone_count()));
        item.zone_rgb = view.colours.data() + first;
    }
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

// Within what reserve() made room for.
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

void Update::list_view(uint32_t v)
{
    View &view = *views[v];
    std::pmr::vector<SortEntry> &listed = frame.listed_;
    listed.clear();
    for (const uint32_t i : frame.visible_) {
        const uint32_t row = frame.candidates_[i].row;
        const ViewVisibility &visibility = view_visibility(v, i);
        if (visibility.inside != math::Containment::outside)
            listed.push_back({crowd.actor(row).tmpl, crowd.actor(row).texture_set, visibility.distance, row});
    }
    sort_entries(listed, frame.ordered_);

    view.list.items.resize(listed.size());
    view.list.server = &view.server;
    view.server.attach(frame.caches_);
    std::copy(std::begin(view.camera.projection), std::end(view.camera.projection), view.list.projection);
    const CameraState &eye = frame.eyes_[v];
    for (int k = 0; k < 3; ++k) view.list.eye[k] = eye.eye[k];
    for (int k = 0; k < 9; ++k) view.list.world_to_eye[k] = eye.world_to_eye[k / 3][k % 3];
    for_slices(static_cast<uint32_t>(listed.size()),
               [&](uint32_t i) { view.list.items[i] = item_of(eye, v, listed[i]); });
    keep_colours(view);
    keep_hooks(crowd, view);
}

void Update::list()
{
    for (uint32_t v = 0; v < views.count; ++v) list_view(v);
}

}  // namespace claque::frame
