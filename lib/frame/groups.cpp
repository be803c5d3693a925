// S0 4.3: culls groups first, by the Group Bsphere. The members of a group that no view meets cost nothing further.
#include <cmath>

#include "lib/frame/steps.h"
#include "lib/math/eye_transform.h"

namespace claque::frame
{

bool CullGroups::is_visible(const CameraState &eye, const Block &block) const
{
    if (block.group == model::none) return true;
    const crowd::Group &group = given.crowd.group(block.group);
    if (!group.enabled) return false;
    if (given.traditional()) return true;
    const crowd::Transform &transform = group.transform;
    const glm::dvec3 turned =
        math::rotation_of(transform.orientation) * (glm::dvec3(block.sphere.centre) * double(transform.scale));
    // The quaternions of members are rounded to float, so members reach a little further than the sum.
    const double radius = std::fabs(double(transform.scale)) * block.sphere.radius * (1 + 1e-5);
    return test_swept(eye.frustum, transform.position - eye.eye + turned, radius, eye.shadow) !=
           math::Containment::outside;
}

base::Status CullGroups::check() const
{
    if (block_seen.count < size_t(given.eyes.count) * blocks.blocks().count)
        return base::Status::bad(CLQ_ARGUMENT, "no room for every block in every view");
    if (tested.count < given.crowd.row_count()) return base::Status::bad(CLQ_ARGUMENT, "no room for every row");
    return base::Status::good();
}

uint32_t CullGroups::run() const
{
    const base::Span<const Block> all = blocks.blocks();
    for (uint32_t v = 0; v < given.eyes.count; ++v) {
        uint8_t *visible = block_seen.data + size_t(v) * all.count;
        given.for_slices(all.count, [&](uint32_t b) { visible[b] = is_visible(given.eyes[v], all[b]); });
    }
    uint32_t count = 0;
    for (uint32_t b = 0; b < all.count; ++b) {
        const Block &block = all[b];
        bool visible = false;
        for (uint32_t v = 0; v < given.eyes.count; ++v) visible = visible || block_seen[v * all.count + b];
        if (!visible) continue;
        for (uint32_t i = block.first; i < block.first + block.count; ++i) tested[count++] = blocks.row(i);
    }
    return count;
}

base::Status NoteGroups::check() const
{
    if (block_seen.count < size_t(given.eyes.count) * blocks.blocks().count)
        return base::Status::bad(CLQ_ARGUMENT, "not every block in every view");
    if (groups.count < given.crowd.group_count()) return base::Status::bad(CLQ_ARGUMENT, "no room for every group");
    return base::Status::good();
}

void NoteGroups::run() const
{
    const base::Span<const Block> all = blocks.blocks();
    stats.groups = stats.groups_visible = 0;
    for (uint32_t b = 0; b < all.count; ++b) {
        const uint32_t group = all[b].group;
        if (group == model::none) continue;
        bool visible = false;
        for (uint32_t v = 0; v < given.eyes.count; ++v) visible = visible || block_seen[v * all.count + b];
        ++stats.groups;
        stats.groups_visible += visible;
        if (visible) groups[group] = {given.update, given.crowd.group(group).generation};
    }
}

}  // namespace claque::frame
