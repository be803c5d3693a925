// S0 4.2, phase 3: where the Sklsroot Bsphere crosses a frustum's edge, which parts are inside, by the Internal Bspheres of
// the pose; who has none is not drawn. In traditional mode everybody is tested here, and here alone.
#include <cmath>

#include "lib/frame/spheres.h"
#include "lib/frame/steps.h"
#include "lib/math/eye_transform.h"
#include "lib/pose/pose.h"

namespace claque::frame
{

using math::Containment;

namespace
{

// Of the nodes that a level evaluates.
uint64_t nodes_of(const model::Template &tmpl, const model::Level &level)
{
    return level.active.empty() ? tmpl.rig.node_count() : level.nodes.size();
}

}  // namespace

// Whether the view sees anything of the individual, and which parts.
void Update::test_parts(uint32_t view, uint32_t index, const animcache::Request &request, PartsTested &tested) const
{
    ViewVisibility &visibility = view_visibility(view, frame.requested_[index]);
    const model::Level &level = request.tmpl->levels[request.level];
    // What lies between two key-poses is in no hull of theirs part by part; and who shows what must not depend on what is kept.
    if (level.parts.empty() || animcache::shows_key_poses(request.key_pose.mode)) return;
    if (!tested.palette)
        tested.palette = frame.caches_.palette_for_spheres(request, tested.slice, tested.products_tracked);
    const CameraState &eye = frame.eyes_[view];
    const crowd::Transform &root = frame.candidates_[frame.requested_[index]].root;
    const ToFrustum to{math::rotation_of(root.orientation) * double(root.scale), root.position - eye.eye,
                       std::fabs(double(root.scale))};
    const PartsInView inside = parts_in_view(*request.tmpl, level, tested.palette, to, eye.frustum);
    tested.spheres_built += inside.built;
    tested.sphere_tests += inside.tested;
    const uint32_t count = static_cast<uint32_t>(level.parts.size());
    const uint64_t all = count == model::max_level_parts ? ~uint64_t(0) : (uint64_t(1) << count) - 1;
    visibility.parts = inside.parts == all ? ~uint64_t(0) : inside.parts;
    if (!inside.parts && !visibility.shadow_only) visibility.inside = Containment::outside;
    else if (visibility.inside == Containment::outside) visibility.inside = Containment::intersects;
}

void Update::cull_parts()
{
    constexpr uint32_t slices = animcache::Caches::slice_count;
    PartsTested tested[slices];
    std::pmr::vector<animcache::Request> &requests = frame.caches_.pending();
    const uint32_t count = static_cast<uint32_t>(requests.size());
    jobs.for_each(slices, [&](uint32_t s) {
        const uint32_t first = static_cast<uint32_t>(uint64_t(count) * s / slices);
        const uint32_t last = static_cast<uint32_t>(uint64_t(count) * (s + 1) / slices);
        tested[s].slice = s;
        for (uint32_t i = first; i < last; ++i) {
            tested[s].palette = nullptr;
            requests[i].drawn = false;
            bool crosses = false;
            const uint64_t tracked_before = tested[s].products_tracked;
            for (uint32_t v = 0; v < views.count; ++v) {
                const ViewVisibility &visibility = view_visibility(v, frame.requested_[i]);
                if (visibility.inside == Containment::outside && !traditional()) continue;
                crosses = crosses || visibility.inside == Containment::intersects;
                if ((visibility.inside == Containment::intersects && !visibility.shadow_only) || traditional())
                    test_parts(v, i, requests[i], tested[s]);
                requests[i].drawn = requests[i].drawn || visibility.inside != Containment::outside;
            }
            tested[s].crossing += crosses;
            if (!requests[i].drawn) tested[s].products_invisible += tested[s].products_tracked - tracked_before;
        }
    });
    Stats &stats = frame.stats_;
    stats.crossing = 0;
    stats.spheres_built = 0, stats.matrices_needed = stats.products = stats.products_tracked = 0;
    for (const PartsTested &t : tested) {
        stats.spheres_built += t.spheres_built;
        stats.sphere_tests += t.sphere_tests;
        stats.crossing += t.crossing;
        stats.products_tracked += t.products_tracked;
        stats.products += t.products_invisible;
    }
    frame.visible_.clear();
    for (uint32_t i = 0; i < count; ++i) {
        const animcache::Request &request = requests[i];
        const uint64_t nodes = nodes_of(*request.tmpl, request.tmpl->levels[request.level]);
        stats.matrices_needed += nodes;
        if (!request.drawn) {
            frame.rows_[request.row].visibility.visible = false;
            continue;
        }
        frame.visible_.push_back(frame.requested_[i]);
        stats.products += nodes;
        if (request.rigid_mode == animcache::RigidMode::vertices) stats.products_tracked += nodes;
    }
}

}  // namespace claque::frame
