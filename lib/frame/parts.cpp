// S0 4.2, phase 3: where the Sklsroot Bsphere crosses a frustum's edge, which parts are inside, by the Internal Bspheres of
// the pose; who has none is not drawn. In traditional mode everybody is tested here, and here alone.
#include <cmath>

#include "lib/frame/spheres.h"
#include "lib/frame/steps.h"
#include "lib/math/place.h"
#include "lib/pose/pose.h"

namespace claque::frame
{

using math::Inside;

namespace
{

constexpr uint32_t strands = 64;

struct Found {
    uint64_t built = 0, tested = 0, crossing = 0, tracked = 0;
};

// Of the nodes that a level evaluates.
uint64_t nodes_of(const model::Template &tmpl, const model::Level &level)
{
    return level.active.empty() ? tmpl.rig.node_count() : level.nodes.size();
}

}  // namespace

void Update::cull_parts()
{
    Found found[strands];
    std::pmr::vector<animcache::Request> &requests = frame.caches_.pending();
    const uint32_t count = static_cast<uint32_t>(requests.size());
    jobs.for_each(strands, [&](uint32_t s) {
        const uint32_t first = static_cast<uint32_t>(uint64_t(count) * s / strands);
        const uint32_t last = static_cast<uint32_t>(uint64_t(count) * (s + 1) / strands);
        Found &sum = found[s];
        for (uint32_t i = first; i < last; ++i) {
            animcache::Request &request = requests[i];
            const Candidate &candidate = frame.candidates_[frame.asked_[i]];
            const model::Level &level = request.tmpl->levels[request.level];
            const math::Affine *palette = nullptr;
            request.drawn = false;
            for (uint32_t v = 0; v < views.count; ++v) {
                Sight &seen = sight(v, frame.asked_[i]);
                if (seen.inside == Inside::no && !traditional()) continue;
                sum.crossing += seen.inside == Inside::crosses;
                const bool tests = (seen.inside == Inside::crosses && !seen.shadow_only) || traditional();
                if (tests && !level.parts.empty()) {
                    if (!palette) palette = frame.caches_.palette_for_spheres(request, s, sum.tracked);
                    if (palette) {
                        const EyeOf &eye = frame.eyes_[v];
                        const crowd::Place &root = candidate.root;
                        const ToFrustum to{math::rotation_of(root.orientation) * double(root.scale),
                                           root.position - eye.eye, std::fabs(double(root.scale))};
                        const PartsInView inside = parts_in_view(*request.tmpl, level, palette, to, eye.frustum);
                        sum.built += inside.built, sum.tested += inside.tested;
                        seen.parts = inside.parts;
                        if (!inside.parts && !seen.shadow_only) seen.inside = Inside::no;
                        else if (seen.inside == Inside::no) seen.inside = Inside::crosses;
                    }
                }
                request.drawn = request.drawn || seen.inside != Inside::no;
            }
        }
    });
    Stats &stats = frame.stats_;
    stats.crossing = 0;
    stats.spheres_built = 0, stats.matrices_needed = stats.products = stats.products_tracked = 0;
    for (const Found &f : found) {
        stats.spheres_built += f.built;
        stats.sphere_tests += f.tested;
        stats.crossing += static_cast<uint32_t>(f.crossing);
        stats.products_tracked += f.tracked;
    }
    frame.visible_.clear();
    for (uint32_t i = 0; i < count; ++i) {
        const animcache::Request &request = requests[i];
        const uint64_t nodes = nodes_of(*request.tmpl, request.tmpl->levels[request.level]);
        stats.matrices_needed += nodes;
        if (!request.drawn) {
            frame.rows_[request.row].seen.visible = false;
            continue;
        }
        frame.visible_.push_back(frame.asked_[i]);
        stats.products += nodes;
        if (request.placement == animcache::Placement::vertices) stats.products_tracked += nodes;
    }
}

}  // namespace claque::frame
