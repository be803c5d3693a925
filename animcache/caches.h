// The animation cache and the geometry cache (S1 4): each individual's last matrix palette, and its skinned positions
// and normals, in memory of their own within one budget. They are invalidated apart: a change of level skins anew from
// the palette that is held. Who finds no room is served while drawing (on_demand.h).
#pragma once

#include "animcache/block_pool.h"
#include "animcache/keyposes.h"
#include "animcache/scratch.h"
#include "animcache/settings.h"
#include "lib/base/services.h"
#include "lib/base/span.h"

namespace claque::animcache
{

struct Counters {
    uint32_t due = 0, animated = 0, skinned = 0, palette_served = 0, vertices_served = 0, on_demand = 0;  // last update
    uint64_t matrices_built = 0;                          // last update: nodes' of those animated
    uint32_t deferred = 0, overdue = 0, over_budget = 0;  // last update: see frame::Stats
    uint64_t evicted = 0;                                 // blocks, ever
    uint64_t bytes = 0;                                   // of blocks in use, now
    uint64_t pool_bytes = 0;                              // that the host has given for them
};

class Caches
{
public:
    Caches(std::pmr::memory_resource *memory, const Settings &settings);
    ~Caches();
    Caches(const Caches &) = delete;
    Caches &operator=(const Caches &) = delete;

    // Room for the book-keeping of `row_count` rows and for the scratch of these templates. The only call that may
    // fail (std::bad_alloc); what is cached stays.
    void reserve(uint32_t row_count, base::Span<const model::Template *const> templates);

    // An update, in this order.
    std::pmr::vector<Request> &begin();  // to be filled with who is seen, ascending by row, within its capacity
    void allocate_poses();               // finds room, throwing out who is unseen for longest
    void find_due_poses();
    // Leaves all but `moment.budget` of those to a later update, as their poses of an earlier one still serve: see
    // budget.cpp. Their requests are then for what is held.
    struct PoseBudget {
        double time_s = 0;
        double elapsed_s = 0;  // since the update before; 0: unknown
        uint32_t budget = 0;
    };
    void defer(const PoseBudget &pose_budget);
    void animate(const base::Jobs &jobs);
    void allocate_vertices();  // from here on only for requests that are drawn
    void find_due_vertices();
    void skin(const base::Jobs &jobs);

    // Between find_due_poses() and animate(): whether a request's pose must be evaluated, here or at draw time.
    bool is_due(const Request &request) const;
    std::pmr::vector<Request> &pending() { return requests_; }

    // Of a row in the last update's requests; null where there was no room.
    const float *palette_of(uint32_t row) const { return entries_[row].palette; }
    draw::Vertices vertices_of(uint32_t row) const;
    // The palette of a request's pose; made in the strand's scratch where there is no room for it, or only nodes' own
    // matrices are kept: then the products that this took are added. `strand` below strand_count.
    const math::Affine *palette_for_spheres(const Request &request, uint32_t slice, uint64_t &products) const;
    // Of one whose parts GL's matrix stack places; null otherwise.
    const math::Affine *locals_of(uint32_t row) const;
    static constexpr uint32_t slice_count = 64;  // tasks an update is cut into, whatever the number of threads
    const Request &request_of(uint32_t row) const { return requests_[entries_[row].request]; }

    bool was_animated(uint32_t row) const { return entries_[row].animated_at == frame_number_; }
    base::Span<const Request> requests() const { return base::Span<const Request>(requests_); }
    const Counters &counters() const { return counters_; }
    const Settings &settings() const { return settings_; }
    const KeyPoses &key_poses() const { return key_poses_; }

private:
    struct Entry {
        const model::Template *tmpl = nullptr;  // whose sizes the blocks have
        float *palette = nullptr;
        float *vertices = nullptr;
        PoseKey palette_key, vertices_key;
        float palette_radius = 0, vertices_radius = 0;  // Request::blend_radius that each was made for
        double shown_s = 0;                             // tick of the palette
        double renewed_s = 0;                           // host's time at which it was made; where updates have budgets
        uint32_t vertices_level = 0;
        uint32_t request = 0;
        uint32_t before = model::none, after = model::none;  // rows, see move_to_end()
        uint64_t last_seen = 0;
        uint64_t animated_at = 0;
    };
    using Block = float *Entry::*;

    // Whose last pose may serve once more.
    struct Waiting {
        double periods;  // that its pose would be old in the next update
        float distance;
        uint32_t row, due;  // the latter of animate_
    };

    bool can_wait(const Request &request, double time_s) const;
    bool needs_vertices(const Request &request) const;
    void skin(const Request &request, const Scratch &scratch);
    float *take(const Entry &wanted, Block kind);  // null: no room
    bool evict_one(uint64_t updates);
    void move_to_end(uint32_t row);
    void release(Entry &entry, Block kind);
    size_t block_bytes(const model::Template &tmpl, Block kind) const;

    Settings settings_;
    BlockPool blocks_;
    Counters counters_;
    uint64_t frame_number_ = 0;
    std::pmr::vector<Request> requests_;  // of the last update
    std::pmr::vector<Entry> entries_;     // by row
    std::pmr::vector<uint32_t> animate_;  // indices of requests
    std::pmr::vector<uint32_t> skin_;
    std::pmr::vector<Waiting> waiting_;
    PoseBudget pose_budget_;                             // of the last update
    uint32_t first_ = model::none, last_ = model::none;  // rows by when they were last seen
    std::pmr::vector<uint32_t> built_;                   // by strand: matrices
    mutable ScratchPool scratch_;
    KeyPoses key_poses_;
};

}  // namespace claque::animcache
