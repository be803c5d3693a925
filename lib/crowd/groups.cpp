// Groups: made, moved, switched on and off; actors join and leave them (S0 4.3, 8).
#include <cmath>

#include "lib/base/error.h"
#include "lib/crowd/crowd.h"
#include "lib/crowd/reserve.h"

namespace claque::crowd
{

using base::fail;

namespace
{

constexpr uint32_t max_groups = 1u << 28;

Transform checked_group_transform(const Transform &transform)
{
    const float size = std::fabs(checked(transform).scale);
    if (!(size >= 1e-6f && size <= 1e6f))
        fail(CLQ_ARGUMENT, "a group's scale is %g: 1e-6 to 1e6 is wanted, either sign",
             static_cast<double>(transform.scale));
    return transform;
}

// Whether numbers can hold it: the place of a member may be beyond them in the world.
bool is_representable(const Transform &transform)
{
    bool good = std::isfinite(transform.scale) && transform.scale != 0;
    for (int k = 0; k < 3; ++k) good = good && std::isfinite(transform.position[k]);
    return good;
}

}  // namespace

uint32_t Crowd::group_row_of(Id id) const
{
    const uint32_t row = id.index1 - 1;
    if (id.index1 == 0 || row >= groups_.size() || groups_[row].generation != id.generation || !(id.generation & 1))
        fail(CLQ_STALE_ID, "no group has index %u and generation %u", id.index1, id.generation);
    return row;
}

Id Crowd::create_group(const Transform &transform)
{
    const Transform placed = checked_group_transform(transform);
    if (first_free_group_ == model::none) {
        if (groups_.size() >= max_groups) fail(CLQ_LIMIT, "a crowd holds at most %u groups", max_groups);
        reserve_one(groups_);
    }
    uint32_t row = first_free_group_;
    if (row == model::none) {
        row = static_cast<uint32_t>(groups_.size());
        groups_.emplace_back();
    } else {
        first_free_group_ = groups_[row].members;
    }
    groups_[row] = Group{placed, groups_[row].generation + 1, 0, true, next_version_++};
    ++structure_version_;
    return group_id_of(row);
}

void Crowd::destroy_group(Id id)
{
    const uint32_t row = group_row_of(id);
    Group &group = groups_[row];
    if (group.members)
        for (uint32_t i = 0; i < row_count(); ++i)
            if (groups_of_[i] == row) {
                const Transform world = world_transform_of(i);
                if (is_representable(world)) transforms_[i] = world;
                leave(i);
            }
    group = Group{Transform(), group.generation + 1, first_free_group_, true, 0};
    if (group.generation != 0xfffffffeu) first_free_group_ = row;
    ++structure_version_;
}

void Crowd::set_group_transform(Id id, const Transform &transform)
{
    const uint32_t row = group_row_of(id);
    groups_[row].transform = checked_group_transform(transform);
}

void Crowd::enable_group(Id id, bool enabled) { groups_[group_row_of(id)].enabled = enabled; }

void Crowd::leave(uint32_t row)
{
    const uint32_t group = groups_of_[row];
    if (group == model::none) return;
    --groups_[group].members;
    groups_[group].version = next_version_++;
    groups_of_[row] = model::none;
    ++structure_version_;
}

void Crowd::join(Id id, Id group_id, const Transform *transform)
{
    const uint32_t row = row_of(id);
    const bool leaves = group_id.index1 == 0 && group_id.generation == 0;
    const uint32_t group = leaves ? model::none : group_row_of(group_id);
    const Transform world = world_transform_of(row);
    const Transform placed = checked(transform ? *transform
                                     : leaves  ? world
                                               : relative(groups_[group].transform, world));
    leave(row);
    transforms_[row] = placed;
    if (leaves) return;
    groups_of_[row] = group;
    ++groups_[group].members;
    groups_[group].version = next_version_++;
    ++structure_version_;
}

}  // namespace claque::crowd
