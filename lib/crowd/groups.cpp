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

Place checked_space(const Place &place)
{
    const float size = std::fabs(checked(place).scale);
    if (!(size >= 1e-6f && size <= 1e6f))
        fail(CLQ_ARGUMENT, "a group's scale is %g: 1e-6 to 1e6 is wanted, either sign",
             static_cast<double>(place.scale));
    return place;
}

// Whether numbers can hold it: the place of a member may be beyond them in the world.
bool is_somewhere(const Place &place)
{
    bool good = std::isfinite(place.scale) && place.scale != 0;
    for (int k = 0; k < 3; ++k) good = good && std::isfinite(place.position[k]);
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

Id Crowd::create_group(const Place &place)
{
    const Place placed = checked_space(place);
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
                const Place world = world_place_of(i);
                if (is_somewhere(world)) places_[i] = world;
                leave(i);
            }
    group = Group{Place(), group.generation + 1, first_free_group_, true, 0};
    if (group.generation != 0xfffffffeu) first_free_group_ = row;
    ++structure_version_;
}

void Crowd::place_group(Id id, const Place &place)
{
    const uint32_t row = group_row_of(id);
    groups_[row].place = checked_space(place);
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
