// The values that flow from one step of an update to the next. State that is kept from update to update is indexed by
// the individual's slot (SeenRows). Results of one update are indexed by candidate, from the first cull phase on.
#pragma once

#include "animcache/caches.h"
#include "lib/base/services.h"
#include "lib/behave/behave.h"
#include "lib/frame/camera_state.h"
#include "lib/frame/settings.h"

namespace claque::frame
{

// Input of every step.
struct Given {
    const crowd::Crowd &crowd;
    const Settings &settings;
    base::Span<const CameraState> eyes;  // one per view
    double time_s;                       // the host's clock
    uint64_t update;                     // number of this update
    const base::Jobs &jobs;
    base::HostCalls &host_calls;  // the ground and host mechanisms

    bool traditional() const { return settings.cull == Cull::traditional; }

    // Runs a loop over n in slices whose number does not depend on the number of threads.
    template <class Body>
    void for_slices(uint32_t n, const Body &body) const
    {
        constexpr uint32_t slice = 256;
        jobs.for_each((n + slice - 1) / slice, [&](uint32_t k) {
            const uint32_t last = n - k * slice < slice ? n : (k + 1) * slice;
            for (uint32_t i = k * slice; i < last; ++i) body(i);
        });
    }

    // The same in a fixed number of parts, for loops that add something up: calls body(part, first, last).
    static constexpr uint32_t part_count = 64;
    template <class Body>
    void for_parts(uint32_t n, const Body &body) const
    {
        const auto begin_of = [n](uint32_t part) { return static_cast<uint32_t>(uint64_t(n) * part / part_count); };
        jobs.for_each(part_count, [&](uint32_t part) { body(part, begin_of(part), begin_of(part + 1)); });
    }
};

// Results of the last update for one row of the crowd.
struct ActorVisibility {
    bool visible = false;  // in any view, in the last update
    float period_s = 0;    // in the last update that saw it; 0: every frame
    double shown_s = 0;    // the tick whose pose it showed then
    float distance = 0;    // eyeDistance then (S0 5): from the Skeleton Root to the nearest eye, world units
    uint32_t level = 0;    // of detail then
};

// What updates keep of an individual that has passed phase 1: as of the last update in which it did.
struct Row {
    ActorVisibility visibility;   // visible: in the update of that number
    uint64_t update = 0;          // the last that examined this row
    uint32_t generation = 0;      // of the individual that these results belong to
    bool visible_before = false;  // seen in the update before as well
    uint64_t shown_at = 0;        // the last update that gave it a tick; 0: none did
    uint32_t candidate = 0;       // its index among that update's candidates
};

struct GroupRow {
    uint64_t update = 0;  // the last that saw it
    uint32_t generation = 0;
};

// An individual that passed phase 1 in at least one view of this update. All views have the same candidates.
struct Candidate {
    uint32_t row = 0;
    uint32_t slot = 0;               // of SeenRows
    float effective_distance_m = 0;  // S0 5: the smallest over the views that see it
    uint64_t levels = 0;             // of its control mechanisms
    crowd::Transform root;           // its Skeleton Root in the world, valid after PlaceRoots
};

// How one view sees one candidate. distance: of its Skeleton Root, world units.
struct ViewVisibility {
    float distance;
    math::Containment inside;  // of the last sphere tested
    bool shadow_only;          // only its shadow is visible
    uint64_t parts;            // bit k: part k of its level
};

struct Visibilities {
    base::Span<ViewVisibility> all;  // [view][candidate]
    uint32_t candidates = 0;         // per view
    ViewVisibility &at(uint32_t view, uint32_t candidate) const { return all[view * candidates + candidate]; }
};

}  // namespace claque::frame
