// S0 4.2, phases 1 and 2, in double relative to the eye: the Refpoint Bsphere holds for every position of the Skeleton
// Root, the Sklsroot Bsphere for the present one. Shadow casters are tested with the volume that their sphere sweeps.
#include <algorithm>
#include <cmath>

#include "lib/frame/steps.h"
#include "lib/math/eye_transform.h"

namespace claque::frame
{

using math::Containment;

namespace
{

double length(const glm::dvec3 &v) { return std::sqrt(v.x * v.x + v.y * v.y + v.z * v.z); }

}  // namespace

base::Status CullRefpoints::check() const
{
    if (passed.count < tested.count) return base::Status::bad(CLQ_ARGUMENT, "no room for all that are tested");
    return check_motions(given, motions);
}

glm::dvec3 CullRefpoints::position_of(uint32_t row, uint32_t follow_slot) const
{
    if (follow_slot != model::none) return motions[follow_slot].position;
    return crowd::reference_position_of(given.crowd, row, given.time_s);
}

bool CullRefpoints::meets(const CameraState &eye, uint32_t row, uint32_t follow_slot) const
{
    const crowd::Crowd &crowd = given.crowd;
    const crowd::Extent &extent = crowd.extent_of(row);
    const uint32_t group = crowd.group_of(row);
    const float outer = group == model::none ? 1 : crowd.group(group).transform.scale;
    const double scale = std::fabs(double(crowd.transform_of(row).scale * outer));
    const double radius = scale * double(extent.refpoint) + double(extent.slack);
    const glm::dvec3 away = position_of(row, follow_slot) - eye.eye;
    return (eye.casts() ? test_swept(eye.frustum, away, radius, eye.shadow) : test(eye.frustum, away, radius)) !=
           Containment::outside;
}

bool CullRefpoints::passes(uint32_t row) const
{
    const uint32_t follow_slot = given.crowd.follows().slot_of(row);
    if (follow_slot != model::none && !motions[follow_slot].present) return false;
    if (given.traditional()) return given.eyes.count > 0;
    for (const CameraState &eye : given.eyes)
        if (meets(eye, row, follow_slot)) return true;
    return false;
}

uint32_t CullRefpoints::run() const
{
    given.for_slices(tested.count, [this](uint32_t i) { passed[i] = passes(tested[i]); });
    uint32_t count = 0;
    for (uint32_t i = 0; i < tested.count; ++i) count += passed[i];
    return count;
}

base::Status ListCandidates::check() const
{
    if (passed.count < tested.count) return base::Status::bad(CLQ_ARGUMENT, "not all that are tested were culled");
    uint32_t count = 0;
    for (uint32_t i = 0; i < tested.count; ++i) count += passed[i] != 0;
    if (candidates.count < count) return base::Status::bad(CLQ_ARGUMENT, "no room for all that passed");
    return base::Status::good();
}

void ListCandidates::run() const
{
    uint32_t count = 0;
    for (uint32_t i = 0; i < tested.count; ++i) {
        if (!passed[i]) continue;
        candidates[count].row = tested[i], candidates[count].slot = seen.insert(tested[i]);
        ++count;
    }
    stats.tested = considered;
    stats.sphere_tests = uint64_t(given.eyes.count) * considered;
    stats.passed_refpoint = count;
}

base::Status CullRoots::check() const
{
    if (visibilities.candidates != candidates.count ||
        visibilities.all.count < size_t(given.eyes.count) * candidates.count)
        return base::Status::bad(CLQ_ARGUMENT, "no room for every candidate in every view");
    return base::Status::good();
}

void CullRoots::run() const
{
    for (uint32_t v = 0; v < given.eyes.count; ++v) {
        const CameraState &eye = given.eyes[v];
        given.for_slices(candidates.count, [&](uint32_t i) {
            const uint32_t row = candidates[i].row;
            const crowd::Transform &root = candidates[i].root;
            const glm::dvec3 away = root.position - eye.eye;
            const glm::dvec3 centre(given.crowd.template_of(row).sklsroot.centre);
            const glm::dvec3 turned = math::rotation_of(root.orientation) * (centre * double(root.scale));
            const double radius = std::fabs(double(root.scale)) * double(given.crowd.extent_of(row).sklsroot);
            ViewVisibility &out = visibilities.at(v, i);
            out.distance = static_cast<float>(length(away));
            out.inside = test(eye.frustum, away + turned, radius);
            out.shadow_only = false;
            out.parts = ~uint64_t(0);
            if (out.inside != Containment::outside || !eye.casts()) return;
            out.inside = test_swept(eye.frustum, away + turned, radius, eye.shadow);
            out.shadow_only = out.inside != Containment::outside;
        });
    }
    stats.sphere_tests += uint64_t(given.eyes.count) * candidates.count;
    stats.distances = uint64_t(given.eyes.count) * candidates.count;
}

}  // namespace claque::frame
