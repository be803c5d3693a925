// S0 4.2: who can be seen, in double relative to the eye: first groups by the sphere round all their members, then
// actors however they are turned (Refpoint Bsphere), then as they are (Sklsroot Bsphere).
#include <cmath>

#include "lib/frame/steps.h"
#include "lib/math/place.h"

namespace claque::frame
{

namespace
{

double length(const glm::dvec3 &v) { return std::sqrt(v.x * v.x + v.y * v.y + v.z * v.z); }

}  // namespace

EyeOf::EyeOf(const Camera &camera)
    : eye(camera.eye), world_to_eye(math::rotation_of(camera.rotation)), frustum(math::frustum_of(camera.projection))
{
}

// The distance of the Reference Point, or -1.
float Update::distance_if_seen(const EyeOf &eye, uint32_t row) const
{
    const crowd::Place &inner = crowd.place_of(row);
    const uint32_t group = crowd.group_of(row);
    const glm::dvec3 position =
        group == model::none ? inner.position : composed_position(crowd.group(group).place, inner.position);
    const model::Template &tmpl = crowd.template_of(row);
    const model::Sphere &sphere = tmpl.sklsroot;
    const glm::dvec3 centre(sphere.centre);
    const float outer = group == model::none ? 1 : crowd.group(group).place.scale;
    const double scale = std::fabs(double(inner.scale * outer));
    const glm::dvec3 away = position - eye.eye;
    const glm::dvec3 refpoint = eye.world_to_eye * away;
    if (test(eye.frustum, refpoint, scale * refpoint_radius(tmpl)) == math::Inside::no) return -1;
    const crowd::Place place = crowd.world_place_of(row);
    const glm::dvec3 turned = math::rotation_of(place.orientation) * (centre * double(place.scale));
    if (test(eye.frustum, refpoint + eye.world_to_eye * turned, scale * sphere.radius) == math::Inside::no) return -1;
    return static_cast<float>(length(away));
}

bool Update::sees(const EyeOf &eye, const Block &block) const
{
    if (block.group == model::none) return true;
    const crowd::Group &group = crowd.group(block.group);
    if (!group.enabled) return false;
    const crowd::Place &place = group.place;
    const glm::dvec3 turned =
        math::rotation_of(place.orientation) * (glm::dvec3(block.sphere.centre) * double(place.scale));
    // A member's turned quaternions are rounded to float: the members reach a little further than the sum says.
    const double radius = std::fabs(double(place.scale)) * block.sphere.radius * (1 + 1e-5);
    return test(eye.frustum, eye.world_to_eye * (place.position - eye.eye + turned), radius) != math::Inside::no;
}

void Update::cull_groups()
{
    ++frame.update_;
    const base::Span<const Block> blocks = frame.blocks_.blocks();
    for (uint32_t v = 0; v < views.count; ++v) {
        const EyeOf eye(views[v]->camera);
        uint8_t *seen = frame.block_seen_.data() + size_t(v) * blocks.count;
        for_slices(blocks.count, [&](uint32_t b) { seen[b] = sees(eye, blocks[b]); });
    }
    frame.candidates_.clear();
    frame.stats_.groups = frame.stats_.groups_seen = 0;
    for (uint32_t b = 0; b < blocks.count; ++b) {
        const Block &block = blocks[b];
        bool seen = false;
        for (uint32_t v = 0; v < views.count; ++v) seen = seen || frame.block_seen_[size_t(v) * blocks.count + b];
        if (block.group != model::none) {
            ++frame.stats_.groups;
            frame.stats_.groups_seen += seen;
            if (seen) frame.groups_[block.group] = {frame.update_, crowd.group(block.group).generation};
        }
        if (!seen) continue;
        for (uint32_t i = block.first; i < block.first + block.count; ++i)
            frame.candidates_.push_back(frame.blocks_.row(i));
    }
}

void Update::place_and_cull()
{
    const uint32_t count = static_cast<uint32_t>(frame.candidates_.size());
    frame.view_distances_.resize(size_t(views.count) * count);
    for (uint32_t v = 0; v < views.count; ++v) {
        const EyeOf eye(views[v]->camera);
        float *distances = frame.view_distances_.data() + size_t(v) * count;
        for_slices(count, [&](uint32_t i) { distances[i] = distance_if_seen(eye, frame.candidates_[i]); });
    }
    frame.stats_.tested = count;
}

}  // namespace claque::frame
