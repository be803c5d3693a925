// S0 4.3: groups first, by the sphere round all their members. Who is in a group that no view meets costs nothing further.
#include <cmath>

#include "lib/frame/steps.h"
#include "lib/math/eye_transform.h"

namespace claque::frame
{

bool Update::is_visible(const CameraState &eye, const Block &block) const
{
    if (block.group == model::none) return true;
    const crowd::Group &group = crowd.group(block.group);
    if (!group.enabled) return false;
    if (traditional()) return true;
    const crowd::Transform &transform = group.transform;
    const glm::dvec3 turned =
        math::rotation_of(transform.orientation) * (glm::dvec3(block.sphere.centre) * double(transform.scale));
    // A member's turned quaternions are rounded to float: the members reach a little further than the sum says.
    const double radius = std::fabs(double(transform.scale)) * block.sphere.radius * (1 + 1e-5);
    return test_swept(eye.frustum, transform.position - eye.eye + turned, radius, eye.shadow) !=
           math::Containment::outside;
}

void Update::cull_groups()
{
    ++frame.update_;
    const base::Span<const Block> blocks = frame.blocks_.blocks();
    for (uint32_t v = 0; v < views.count; ++v) {
        const CameraState &eye = frame.eyes_[v];
        uint8_t *visible = frame.block_visible_.data() + size_t(v) * blocks.count;
        for_slices(blocks.count, [&](uint32_t b) { visible[b] = is_visible(eye, blocks[b]); });
    }
    frame.tested_.clear();
    frame.stats_.groups = frame.stats_.groups_visible = 0;
    for (uint32_t b = 0; b < blocks.count; ++b) {
        const Block &block = blocks[b];
        bool visible = false;
        for (uint32_t v = 0; v < views.count; ++v)
            visible = visible || frame.block_visible_[size_t(v) * blocks.count + b];
        if (block.group != model::none) {
            ++frame.stats_.groups;
            frame.stats_.groups_visible += visible;
            if (visible) frame.groups_[block.group] = {frame.update_, crowd.group(block.group).generation};
        }
        if (!visible) continue;
        for (uint32_t i = block.first; i < block.first + block.count; ++i)
            frame.tested_.push_back(frame.blocks_.row(i));
    }
}

}  // namespace claque::frame
