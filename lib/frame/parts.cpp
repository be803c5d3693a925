// S0 4.2, phase 3: where the Sklsroot Bsphere crosses a frustum's edge, the Internal Bspheres of the pose show which
// parts are inside. An individual without visible parts is not drawn. Traditional mode tests all individuals here, and
// only here.
#include <algorithm>
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

// Number of nodes that a level evaluates.
uint64_t nodes_of(const model::Template &tmpl, const model::Level &level)
{
    return level.active.empty() ? tmpl.rig.node_count() : level.nodes.size();
}

}  // namespace

// Results of one task of phase 3.
struct CullParts::Tested {
    uint32_t slice = 0;
    const math::Affine *palette = nullptr;  // of the present candidate; null until it is needed
    uint64_t spheres_built = 0, sphere_tests = 0, products_tracked = 0;
    uint64_t products_invisible = 0;  // of these, for individuals found invisible
    uint64_t nodes = 0, nodes_drawn = 0, nodes_drawn_on_cpu = 0;
    uint32_t crossing = 0, first = 0, drawn = 0;
};

// Whether the view sees any part of the individual, and which.
void CullParts::test_parts(uint32_t view, uint32_t i, Tested &tested) const
{
    const animcache::Request &request = caches.requests()[i];
    ViewVisibility &visibility = visibilities.at(view, i);
    const model::Level &level = request.tmpl->levels[request.level];
    // Blended key-poses can leave the hulls of single parts. Culling must not depend on which key-poses are kept, so
    // all actors with key-poses skip it.
    if (level.parts.empty() || animcache::shows_key_poses(request.key_pose.mode)) return;
    if (!tested.palette) tested.palette = caches.palette_for_spheres(request, tested.slice, tested.products_tracked);
    if (!tested.palette) return;  // no memory for the pose
    const CameraState &eye = given.eyes[view];
    const crowd::Transform &root = candidates[i].root;
    const ToFrustum to{math::rotation_of(root.orientation) * double(root.scale), root.position - eye.eye,
                       std::fabs(double(root.scale))};
    const PartsInView inside = parts_in_view(*request.tmpl, level, tested.palette, to, eye.frustum);
    tested.spheres_built += inside.built;
    tested.sphere_tests += inside.tested;
    const uint32_t count = static_cast<uint32_t>(level.parts.size());
    const uint64_t all = count == model::max_level_parts ? ~uint64_t(0) : (uint64_t(1) << count) - 1;
    visibility.parts = inside.parts == all ? ~uint64_t(0) : inside.parts;
    if (inside.parts) {
        if (visibility.inside == Containment::outside) visibility.inside = Containment::intersects;
        return;
    }
    // Beside the picture, but its sphere reaches in: so may its shadow.
    if (eye.casts() && visibility.inside != Containment::outside) visibility.shadow_only = true;
    if (visibility.shadow_only) visibility.parts = ~uint64_t(0);
    else visibility.inside = Containment::outside;
}

// Tests the candidate in all views.
void CullParts::test(uint32_t i, Tested &tested) const
{
    animcache::Request &request = caches.pending()[i];
    tested.palette = nullptr;
    request.drawn = false;
    if (!request.tmpl) return;
    bool crosses = false;
    const uint64_t tracked_before = tested.products_tracked;
    for (uint32_t v = 0; v < given.eyes.count; ++v) {
        const ViewVisibility &visibility = visibilities.at(v, i);
        if (visibility.inside == Containment::outside && !given.traditional()) continue;
        crosses = crosses || visibility.inside == Containment::intersects;
        if ((visibility.inside == Containment::intersects && !visibility.shadow_only) || given.traditional())
            test_parts(v, i, tested);
        request.drawn = request.drawn || visibility.inside != Containment::outside;
    }
    tested.crossing += crosses;
    if (!request.drawn) tested.products_invisible += tested.products_tracked - tracked_before;
}

base::Status CullParts::check() const
{
    if (caches.requests().count != candidates.count || visibilities.candidates != candidates.count)
        return base::Status::bad(CLQ_ARGUMENT, "no request or no visibility of every candidate");
    if (visible.count < candidates.count || !has_slots(candidates, {rows.data, rows.count}))
        return base::Status::bad(CLQ_ARGUMENT, "no room for every candidate");
    return base::Status::good();
}

// Lists the candidate if it is drawn.
void CullParts::note(uint32_t i, Tested &tested) const
{
    const animcache::Request &request = caches.requests()[i];
    if (!request.tmpl) return;
    const uint64_t nodes = nodes_of(*request.tmpl, request.tmpl->levels[request.level]);
    tested.nodes += nodes;
    if (!request.drawn) {
        rows[request.slot].visibility.visible = false;
        return;
    }
    visible[tested.first + tested.drawn++] = i;
    tested.nodes_drawn += nodes;
    if (request.rigid_mode == animcache::RigidMode::vertices) tested.nodes_drawn_on_cpu += nodes;
}

uint32_t CullParts::run() const
{
    static_assert(Given::part_count == animcache::Caches::slice_count, "a part has the scratch of a slice");
    Tested tested[Given::part_count];
    given.for_parts(candidates.count, [&](uint32_t part, uint32_t first, uint32_t last) {
        tested[part].slice = part, tested[part].first = first;
        for (uint32_t i = first; i < last; ++i) test(i, tested[part]), note(i, tested[part]);
    });
    stats.crossing = 0;
    stats.spheres_built = 0, stats.matrices_needed = stats.products = stats.products_tracked = 0;
    uint32_t count = 0;
    for (const Tested &t : tested) {
        stats.spheres_built += t.spheres_built;
        stats.sphere_tests += t.sphere_tests;
        stats.crossing += t.crossing;
        stats.matrices_needed += t.nodes;
        stats.products_tracked += t.products_tracked + t.nodes_drawn_on_cpu;
        stats.products += t.products_invisible + t.nodes_drawn;
        std::copy(visible.data + t.first, visible.data + t.first + t.drawn, visible.data + count);
        count += t.drawn;
    }
    return count;
}

}  // namespace claque::frame
