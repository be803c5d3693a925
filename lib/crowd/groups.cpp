// Groups: made, moved, switched on and off; actors join and leave them (S0 4.3, 8).
#include "lib/base/error.h"
#include "lib/crowd/crowd.h"
#include "lib/crowd/reserve.h"

namespace claque::crowd
{

using base::fail;

namespace
{

constexpr uint32_t max_groups = 1u << 28;

}  // namespace

uint32_t Crowd::group_row_of(Id id) const
{
    const uint32_t row = id.index1 - 1;
    if (id.index1 == 0 || row >= groups_.size() || groups_[row].generation != id.generation || !(id.generation & 1))
        fail(CLQ_STALE_ID, "no group has index %u and generation %u", id.index1, id.generation);
    return row;
}

Id Crowd::create_group(const Place &place)
{
    const Place placed = checked(place);
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
                places_[i] = world_place_of(i);
                leave(i);
            }
    group = Group{Place(), group.generation + 1, first_free_group_, true, 0};
    if (group.generation != 0xfffffffeu) first_free_group_ = row;
    ++structure_version_;
}

void Crowd::place_group(Id id, const Place &place)
{
    const uint32_t row = group_row_of(id);
    groups_[row].place = checked(place);
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

void Crowd::join(Id id, Id group_id, const Place *place)
{
    const uint32_t row = row_of(id);
    const bool leaves = group_id.index1 == 0 && group_id.generation == 0;
    const uint32_t group = leaves ? model::none : group_row_of(group_id);
    const Place world = world_place_of(row);
    const Place placed = checked(place ? *place : leaves ? world : relative(groups_[group].place, world));
    leave(row);
    places_[row] = placed;
    if (leaves) return;
    groups_of_[row] = group;
    ++groups_[group].members;
    groups_[group].version = next_version_++;
    ++structure_version_;
}

}  // namespace claque::crowd
