// S0 4.2, phases 1 and 2: who can be seen, in double relative to the eye; first wherever its Skeleton Root is (Refpoint
// Bsphere), then as it is placed (Sklsroot Bsphere). Casters of shadows are tested with all that their sphere sweeps.
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

glm::dvec3 Update::position_of(uint32_t row) const
{
    const crowd::Transform &inner = crowd.transform_of(row);
    const uint32_t group = crowd.group_of(row);
    return group == model::none ? inner.position : composed_position(crowd.group(group).transform, inner.position);
}

void Update::cull_refpoints()
{
    const uint32_t count = static_cast<uint32_t>(frame.tested_.size());
    frame.passed_.resize(size_t(views.count) * count);
    for (uint32_t v = 0; v < views.count; ++v) {
        const CameraState &eye = frame.eyes_[v];
        const bool casts = views[v]->shadow != glm::vec3(0);
        uint8_t *passed = frame.passed_.data() + size_t(v) * count;
        for_slices(count, [&](uint32_t i) {
            const uint32_t row = frame.tested_[i];
            const crowd::Extent &extent = crowd.extent_of(row);
            const uint32_t group = crowd.group_of(row);
            const float outer = group == model::none ? 1 : crowd.group(group).transform.scale;
            const double scale = std::fabs(double(crowd.transform_of(row).scale * outer));
            const double radius = scale * double(extent.refpoint) + double(extent.slack);
            const glm::dvec3 away = position_of(row) - eye.eye;
            passed[i] = static_cast<uint8_t>(casts ? test_swept(eye.frustum, away, radius, eye.shadow)
                                                   : test(eye.frustum, away, radius));
        });
    }
    frame.stats_.tested = count;
    frame.stats_.sphere_tests = uint64_t(views.count) * count;

    frame.candidates_.clear();
    for (uint32_t i = 0; i < count; ++i) {
        bool any = traditional() && views.count > 0;
        for (uint32_t v = 0; v < views.count; ++v) any = any || frame.passed_[size_t(v) * count + i] != 0;
        if (any) frame.candidates_.push_back(Candidate{frame.tested_[i], 0, 0, crowd::Transform()});
    }
    frame.stats_.passed_refpoint = static_cast<uint32_t>(frame.candidates_.size());
}

void Update::cull_roots()
{
    const uint32_t count = static_cast<uint32_t>(frame.candidates_.size());
    frame.view_visibilities_.resize(size_t(views.count) * count);
    for (uint32_t v = 0; v < views.count; ++v) {
        const CameraState &eye = frame.eyes_[v];
        const bool casts = views[v]->shadow != glm::vec3(0);
        for_slices(count, [&](uint32_t i) {
            const Candidate &candidate = frame.candidates_[i];
            const crowd::Transform &root = candidate.root;
            const glm::dvec3 away = root.position - eye.eye;
            const glm::dvec3 centre(crowd.template_of(candidate.row).sklsroot.centre);
            const glm::dvec3 turned = math::rotation_of(root.orientation) * (centre * double(root.scale));
            const double radius = std::fabs(double(root.scale)) * double(crowd.extent_of(candidate.row).sklsroot);
            ViewVisibility &out = view_visibility(v, i);
            out.distance = static_cast<float>(length(away));
            out.inside = test(eye.frustum, away + turned, radius);
            out.shadow_only = false;
            out.parts = ~uint64_t(0);
            if (out.inside != Containment::outside || !casts) return;
            out.inside = test_swept(eye.frustum, away + turned, radius, eye.shadow);
            out.shadow_only = out.inside != Containment::outside;
        });
    }
    frame.stats_.sphere_tests += uint64_t(views.count) * count;
    frame.stats_.distances = uint64_t(views.count) * count;
}

}  // namespace claque::frame
