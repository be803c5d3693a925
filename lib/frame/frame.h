// One update of a crowd: who is seen, at what rate and level, posed, skinned, listed (S0 4.2, S1 4).
#pragma once

#include "animcache/caches.h"
#include "lib/base/services.h"
#include "lib/base/status.h"
#include "lib/behave/behave.h"
#include "lib/crowd/crowd.h"
#include "lib/frame/blocks.h"
#include "lib/frame/camera_state.h"
#include "lib/frame/order.h"
#include "lib/frame/stats.h"
#include "lib/frame/view.h"
#include "lib/math/frustum.h"

namespace claque::frame
{

// S0 4: the order of work. The picture is the same.
enum class Cull : uint8_t { actor = 0, traditional = 1 };

// Whether what is shown has a memory (SPEC 2): live, nobody shows an earlier tick than it has shown.
enum class Clock : uint8_t { reference = 0, live = 1 };

// A host's clock, for budgets in milliseconds alone.
struct HostClock {
    double (*now_s)(void *user) = nullptr;
    void *user = nullptr;
};

// What a host chooses about updates, beside the caches.
struct Settings {
    animcache::Settings caches;
    Cull cull = Cull::actor;
    animcache::RigidMode rigid_mode = animcache::RigidMode::vertices;
    Clock clock = Clock::reference;
    uint32_t update_budget = 0;  // poses renewed in an update at most; 0: all that are due. Needs caches.can_defer
    float update_budget_ms = 0;  // of posing and skinning; 0: no limit. Needs `now`
    HostClock now;
    float lod_scale = 1;       // times every effective distance
    float lod_hysteresis = 0;  // [0, 1): 0 keeps what is shown a function of time and distance
};

// What the last update found out about one row of the crowd.
struct ActorVisibility {
    bool visible = false;  // in any view, in the last update
    float period_s = 0;    // of the last update that saw it; 0: every frame
    double shown_s = 0;    // the tick whose pose it showed then
    float distance = 0;    // eyeDistance then (S0 5): from the Skeleton Root to the nearest eye, world units
    uint32_t level = 0;    // of detail then
};

// What updates of one crowd keep and reuse: results, caches, scratch. Give each crowd one, of the same memory.
class Frame
{
public:
    Frame(std::pmr::memory_resource *memory, const Settings &settings);

    const Stats &stats() const { return stats_; }
    void reset_bands();
    void forget();  // who was seen: the crowd's state has been replaced. Caches tell states apart by themselves
    // Nothing was seen of a row that was filled after the last update.
    ActorVisibility visibility(const crowd::Crowd &crowd, uint32_t row) const;
    // Where the Skeleton Root of a row was in the world, in the last update if that saw it. False: it did not.
    bool root_of(const crowd::Crowd &crowd, uint32_t row, crowd::Transform &out) const;
    const Settings &settings() const { return settings_; }
    double last_time_s() const { return last_time_s_; }  // of the last update; 0 before the first
    // Of the mechanisms of a row that the last update saw.
    behave::MechanismLevels mechanism_levels(uint32_t row) const { return candidates_[rows_[row].candidate].levels; }
    // Whether any view of the last update met the group's sphere; false where it was disabled or empty.
    bool group_visible(const crowd::Crowd &crowd, uint32_t group) const;

private:
    friend struct Update;

    // One row of the crowd, as the last update found it.
    struct Row {
        ActorVisibility visibility;   // visible: in the update of that number
        uint64_t update = 0;          // the last that looked at this row
        uint32_t generation = 0;      // of the individual that this is about
        bool visible_before = false;  // seen in the update before as well
        uint64_t shown_at = 0;        // the last update that gave it a tick; 0: none did
        uint32_t candidate = 0;
    };
    // One row that passed phase 1 in any view.
    struct Candidate {
        uint32_t row;
        float effective_distance_m;  // S0 5: the least of its effective distances
        uint64_t levels;             // of its control mechanisms
        crowd::Transform root;       // its Skeleton Root in the world, from place_roots() on
    };
    // How one view sees one candidate. distance: of its Skeleton Root, world units.
    struct ViewVisibility {
        float distance;
        math::Containment inside;  // of the last sphere tested
        bool shadow_only;          // nothing but what falls from it
        uint64_t parts;            // bit k: part k of its level
    };
    struct GroupRow {
        uint64_t update = 0;  // the last that saw it
        uint32_t generation = 0;
    };

    Settings settings_;
    animcache::Caches caches_;
    Stats stats_;
    double last_time_s_ = 0;
    bool has_last_time_ = false;
    uint64_t update_ = 0;      // number of the present or last one
    uint64_t live_since_ = 0;  // what was shown up to this update binds nobody: time has run back
    double pose_cost_s_ = 0;   // of posing and skinning one, in the updates before; 0: not known
    std::pmr::vector<Row> rows_;
    std::pmr::vector<GroupRow> groups_;
    Blocks blocks_;
    std::pmr::vector<CameraState> eyes_;       // one a view
    std::pmr::vector<uint8_t> block_visible_;  // [view][block]
    std::pmr::vector<uint32_t> tested_;        // rows that no group keeps out of every view
    std::pmr::vector<uint8_t> passed_;         // [view][tested]: math::Inside of phase 1
    std::pmr::vector<Candidate> candidates_;
    std::pmr::vector<ViewVisibility> view_visibilities_;  // [view][candidate]
    std::pmr::vector<uint32_t> requested_;                // candidates, one a request, in their order
    std::pmr::vector<uint32_t> visible_;                  // of these, who is drawn in some view
    std::pmr::vector<pose::Layer> layers_;                // of who shows more than one clip
    std::pmr::vector<crowd::Mask> masks_;                 // that these may point at
    std::pmr::vector<float> dofs_;                        // of who is due, written by control mechanisms
    std::pmr::vector<uint32_t> behaving_;                 // requests whose mechanisms run
    uint32_t max_dofs_ = 0;
    std::pmr::vector<SortEntry> listed_, ordered_;  // of one view; scratch of its order
};

// One frame. time_s: the host's clock; may jump, also back. What is shown is a function of it and of the distances.
//   views   each with its camera; their lists are written. The lists of views that are not among them point at memory
//           that may be gone: clear them
// Fails: CLQ_ARGUMENT (a time or camera that is not finite), CLQ_OUT_OF_MEMORY; lists and results are then as they
// were. Never throws. Allocates only when something has grown since the last one.
base::Status update(const crowd::Crowd &crowd, Frame &frame, base::Span<View *const> views, double time_s,
                    const base::Jobs &jobs) noexcept;

}  // namespace claque::frame
