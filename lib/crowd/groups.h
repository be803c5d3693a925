// Groups: actors that are tested and moved together, such as a vehicle with its occupants, a flock, a block of seats
// (S0 4.3, 8).
#pragma once

#include "lib/base/slot_map.h"
#include "lib/crowd/transform.h"
#include "lib/model/rig.h"

namespace claque::crowd
{

struct GroupRow {
    Transform transform;  // of the group's space in the world
    uint32_t members = 0;
    bool enabled = true;   // the members of a disabled group are neither updated nor drawn
    uint64_t version = 0;  // changes whenever the group's sphere may have changed
    float speed = 0;       // world units a second: how fast the host moves it
};

using Group = base::Slot<GroupRow>;  // with the generation of its id

struct Groups {
    explicit Groups(std::pmr::memory_resource *memory) : all(memory), of(memory) {}

    base::SlotMap<GroupRow> all;
    model::Array<uint32_t> of;  // by row of actors: the row of the actor's group, or none
};

}  // namespace claque::crowd
