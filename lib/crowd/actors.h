// The actors of a crowd: the columns that every actor has, one row per actor.
#pragma once

#include "lib/base/slot_map.h"
#include "lib/crowd/play.h"
#include "lib/crowd/transform.h"
#include "lib/math/rough_sphere.h"

namespace claque::crowd
{

using Id = base::SlotId;

struct ActorRow {
    uint32_t tmpl = 0;  // index in Crowd::templates()
    uint64_t seed = 0;
    uint64_t play_version = 0;       // new for every play of every individual: unique in the crowd
    uint32_t colours = model::none;  // slot in its template's colour table; none: the template's own
    uint32_t texture_set = 0;        // of its template
};

using Actor = base::Slot<ActorRow>;  // with the generation of its id

// The data that culling needs of one actor beside its transform. Radii at scale 1.
struct Extent {
    float refpoint = 0;  // round the Reference Point, for every position of the Skeleton Root and every rotation
    float sklsroot = 0;  // round the template's Sklsroot centre
    float slack = 0;     // world units: how far the ground may move it
    float priority = 0;  // [0, 1] S0 5
    float speed = 0;     // world units a second: how fast the host moves it
};

struct Actors {
    explicit Actors(std::pmr::memory_resource *memory)
        : all(memory), transforms(memory), plays(memory), extents(memory), bounds(memory), watched(memory)
    {
    }

    base::SlotMap<ActorRow> all;  // decides which rows of all tables are in use
    model::Array<Transform> transforms;
    model::Array<Play> plays;
    model::Array<Extent> extents;
    // Holds the Refpoint Bsphere at any time, in the world. Of a group's members, everything: their group moves.
    model::Array<math::RoughSphere> bounds;
    model::Array<uint32_t> watched;  // rows with events of clips enabled, ascending
};

}  // namespace claque::crowd
