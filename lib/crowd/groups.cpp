// Makes, moves, enables and disables groups; actors join and leave them (S0 4.3, 8).
#include "lib/crowd/groups.h"

#include <cmath>

#include "lib/base/error.h"
#include "lib/crowd/edits.h"
#include "lib/crowd/rows.h"

namespace claque::crowd
{

using base::fail;
using model::none;

namespace
{

// Scales of a group and its members multiply: these limits keep the product finite.
Transform checked_group_transform(const Transform &transform)
{
    const float size = std::fabs(checked(transform).scale);
    if (!(size >= 1e-6f && size <= 1e6f))
        fail(CLQ_ARGUMENT, "a group's scale is %g: 1e-6 to 1e6 is wanted, either sign",
             static_cast<double>(transform.scale));
    return transform;
}

// Whether the transform is finite: the world position of a member may overflow.
bool is_representable(const Transform &transform)
{
    bool good = std::isfinite(transform.scale) && transform.scale != 0;
    for (int k = 0; k < 3; ++k) good = good && std::isfinite(transform.position[k]);
    return good;
}

}  // namespace

void enter_group(Crowd &crowd, uint32_t row, uint32_t group) noexcept
{
    crowd.tables.groups.of[row] = group;
    ++crowd.tables.groups.all[group].members;
    touch_group(crowd, row);
    note(crowd, row);
    ++crowd.structure;
}

void leave_group(Crowd &crowd, uint32_t row) noexcept
{
    uint32_t &group = crowd.tables.groups.of[row];
    if (group == none) return;
    touch_group(crowd, row);
    --crowd.tables.groups.all[group].members;
    group = none;
    note(crowd, row);
    ++crowd.structure;
}

Id create_group(Crowd &crowd, const Transform &transform)
{
    const Transform placed = checked_group_transform(transform);
    base::SlotMap<GroupRow> &groups = crowd.tables.groups.all;
    if (!groups.has_room()) fail(CLQ_LIMIT, "a crowd holds at most %u groups", groups.max_size());
    groups.reserve();
    for (Changes *reader : crowd.readers) reader->groups.reserve(groups.capacity());
    const uint32_t row = groups.take();
    groups[row] = GroupRow{placed, 0, true, crowd.next_version++, 0};
    ++crowd.structure;
    return groups.id_of(row);
}

void destroy_group(Crowd &crowd, Id id)
{
    const uint32_t row = crowd.group_row_of(id);
    for (uint32_t i = 0; crowd.group(row).members > 0 && i < crowd.row_count(); ++i) {
        if (crowd.group_of(i) != row) continue;
        const Transform world = crowd.world_transform_of(i);
        if (is_representable(world)) crowd.tables.actors.transforms[i] = world;
        leave_group(crowd, i);
    }
    crowd.tables.groups.all.free(row);
    ++crowd.structure;
}

void set_group_transform(Crowd &crowd, Id id, const Transform &transform)
{
    const Transform placed = checked_group_transform(transform);
    const uint32_t row = crowd.group_row_of(id);
    crowd.tables.groups.all[row].transform = placed;
    note_group(crowd, row);
}

void set_group_speed(Crowd &crowd, Id id, float speed)
{
    crowd.tables.groups.all[crowd.group_row_of(id)].speed = checked_speed(speed);
}

void enable_group(Crowd &crowd, Id id, bool enabled)
{
    crowd.tables.groups.all[crowd.group_row_of(id)].enabled = enabled;
}

void join(Crowd &crowd, Id id, Id group_id, const Transform *transform)
{
    const uint32_t row = crowd.row_of(id);
    const bool leaves = group_id.index1 == 0 && group_id.generation == 0;
    const uint32_t group = leaves ? none : crowd.group_row_of(group_id);
    if (crowd.follows().of(row)) fail(CLQ_ARGUMENT, "an actor that follows a track cannot join a group");
    const Transform world = crowd.world_transform_of(row);
    const Transform placed = checked(transform ? *transform
                                     : leaves  ? world
                                               : relative(crowd.group(group).transform, world));
    leave_group(crowd, row);
    crowd.tables.actors.transforms[row] = placed;
    note(crowd, row);
    if (!leaves) enter_group(crowd, row, group);
}

}  // namespace claque::crowd
