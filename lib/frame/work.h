// State that updates of one crowd keep and reuse: results, caches, and scratch memory of the steps.
#pragma once

#include "lib/frame/blocks.h"
#include "lib/frame/frame_data.h"
#include "lib/frame/order.h"
#include "lib/frame/seen_rows.h"
#include "lib/frame/stats.h"
#include "lib/frame/step_times.h"
#include "lib/frame/view.h"
#include "lib/frame/view_changes.h"

namespace claque::frame
{

struct Work {
    Work(std::pmr::memory_resource *memory, const Settings &settings);

    // Reserves the memory that the first cull phase needs. The last update's results do not depend on what that phase
    // writes.
    void reserve(const crowd::Crowd &crowd, base::Span<View *const> views);
    // Then reserves all other memory that an update of these views needs, except for palettes and vertices. `count`:
    // the individuals that passed that phase. `unseen`: those of them that have no slot, because no earlier update let
    // them through. Both may throw std::bad_alloc; draw lists and results are unchanged then.
    void reserve_candidates(const crowd::Crowd &crowd, base::Span<View *const> views, uint32_t count, uint32_t unseen);
    // Begins an update. Until its poses are evaluated, undo() puts back what the last one left.
    void begin(const crowd::Crowd &crowd);
    void undo();
    uint64_t bytes() const;  // held besides the caches' contents

    Settings settings;
    animcache::Caches caches;
    Stats stats;

    // Kept from update to update.
    double last_time_s = 0;
    bool has_last_time = false;
    uint64_t update = 0;      // number of the present or last one
    uint64_t live_since = 0;  // ticks shown up to this update may be followed by earlier ones: time has run back
    double pose_cost_s = 0;   // of posing and skinning one individual, measured in earlier updates; 0: unknown
    SeenRows seen;
    std::pmr::vector<Row> rows;  // by slot of `seen`
    std::pmr::vector<GroupRow> groups;
    Blocks blocks;
    ViewChanges view_changes;  // for hosts; no step reads it
    HostClock step_clock;      // of the host; none: steps are not measured
    StepTimes step_times;      // for hosts, of the last update

    // Of one update. Arrays have the maximum size; steps return how much of them they filled.
    std::pmr::vector<CameraState> eyes;       // one per view
    std::pmr::vector<uint8_t> block_seen;     // [view][block]
    std::pmr::vector<uint32_t> tested;        // rows left by CullGroups, then those left by CullBounds
    std::pmr::vector<track::Motion> motions;  // by slot of Follows
    std::pmr::vector<uint8_t> passed;         // [tested]; also scratch of CullBounds and MakeRequests
    std::pmr::vector<Candidate> candidates;
    std::pmr::vector<ViewVisibility> visibilities;  // [view][candidate]
    std::pmr::vector<uint32_t> visible;             // candidates drawn in some view
    std::pmr::vector<pose::Layer> layers;           // of actors that show more than one clip
    std::pmr::vector<float> dofs;                   // of actors that are due, written by control mechanisms
    std::pmr::vector<uint32_t> behaving;            // candidates whose mechanisms run
    uint32_t dofs_each = 0;                         // the maximum over all templates
    std::pmr::vector<SortEntry> listed, ordered;    // of one view; scratch of the sort

    // Of the last update, while the present one runs. Requests point at layers and dofs. The others are kept only where
    // a callback of the host may make an update fail.
    struct Last {
        explicit Last(std::pmr::memory_resource *memory)
            : rows(memory), groups(memory), candidates(memory), layers(memory), dofs(memory)
        {
        }
        std::pmr::vector<Row> rows;
        std::pmr::vector<GroupRow> groups;
        std::pmr::vector<Candidate> candidates;
        std::pmr::vector<pose::Layer> layers;
        std::pmr::vector<float> dofs;
        Stats stats;
        uint64_t live_since = 0;
    } last;
};

}  // namespace claque::frame
