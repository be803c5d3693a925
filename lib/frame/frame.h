// One update of a crowd: who is seen, at what rate and level, posed, skinned, listed (S0 4.2, S1 4).
#pragma once

#include "animcache/caches.h"
#include "lib/base/services.h"
#include "lib/base/status.h"
#include "lib/crowd/crowd.h"
#include "lib/frame/blocks.h"
#include "lib/frame/stats.h"
#include "lib/frame/view.h"

namespace claque::frame
{

// What the last update found out about one row of the crowd.
struct Seen {
    bool visible = false;  // in any view, in the last update
    float period_s = 0;    // of the last update that saw it; 0: every frame
    double shown_s = 0;    // the tick whose pose it showed then
};

// What updates of one crowd keep and reuse: results, caches, scratch. Give each crowd one, of the same memory.
class Frame
{
public:
    Frame(std::pmr::memory_resource *memory, const animcache::Settings &settings);

    const Stats &stats() const { return stats_; }
    void reset_bands();
    // Nothing was seen of a row that was filled after the last update.
    Seen seen(const crowd::Crowd &crowd, uint32_t row) const;
    // Whether any view of the last update met the group's sphere; false where it was disabled or empty.
    bool group_seen(const crowd::Crowd &crowd, uint32_t group) const;

private:
    friend struct Update;

    // One row of the crowd, as the last update found it.
    struct Row {
        Seen seen;                // visible: in the update of that number
        uint64_t update = 0;      // the last that looked at this row
        uint32_t generation = 0;  // of the individual that this is about
        uint32_t level = 0;
        float distance = 0;   // eyeDistance: to the nearest eye that sees it, world units
        bool steady = false;  // seen in the update before as well
    };
    // One individual in one view, before its Item is written.
    struct Listed {
        uint32_t tmpl;  // of Crowd::templates()
        float distance;
        uint32_t row;
    };
    struct GroupRow {
        uint64_t update = 0;  // the last that saw it
        uint32_t generation = 0;
    };

    animcache::Settings settings_;
    animcache::Caches caches_;
    Stats stats_;
    double last_time_s_ = 0;
    bool has_last_time_ = false;
    uint64_t update_ = 0;  // number of the present or last one
    std::pmr::vector<Row> rows_;
    std::pmr::vector<GroupRow> groups_;
    Blocks blocks_;
    std::pmr::vector<uint32_t> candidates_;   // rows that no group keeps out of every view
    std::pmr::vector<uint8_t> block_seen_;    // [view][block]
    std::pmr::vector<float> view_distances_;  // [view][candidate], world units; negative: not seen
    std::pmr::vector<uint32_t> visible_;      // candidates that a view sees, one a request, in their order
    std::pmr::vector<Listed> listed_;         // of one view
};

// One frame. time_s: the host's clock; may jump, also back. What is shown is a function of it and of the distances.
//   views   each with its camera; their lists are written. The lists of views that are not among them point at memory
//           that may be gone: clear them
// Fails: CLQ_ARGUMENT (a time or camera that is not finite), CLQ_OUT_OF_MEMORY; lists and results are then as they
// were. Never throws. Allocates only when something has grown since the last one.
base::Status update(const crowd::Crowd &crowd, Frame &frame, base::Span<View *const> views, double time_s,
                    const base::Jobs &jobs) noexcept;

}  // namespace claque::frame
