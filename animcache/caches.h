// The animation cache and the geometry cache (S1 4): each individual's last matrix palette, and its skinned positions
// and normals, in blocks of its own within one budget. They are invalidated separately: a change of level skins anew
// from the cached palette. Results that no cache keeps or has room for are made for this update alone (frame_arena.h).
#pragma once

#include "animcache/block_pool.h"
#include "animcache/frame_arena.h"
#include "animcache/keyposes.h"
#include "animcache/scratch.h"
#include "animcache/settings.h"
#include "lib/base/services.h"
#include "lib/base/span.h"

namespace claque::animcache
{

// Of the last update, except for `evicted` and bytes. The crowd's statistics are these and those of lib/frame.
struct Counters {
    uint32_t due = 0;               // individuals whose cached palette was not that of their tick
    uint32_t animated = 0;          // poses evaluated
    uint64_t matrices_built = 0;    // matrices of nodes, for these poses (S0 6.2.2, NO_01; fCoh is their share)
    uint32_t skinned = 0;           // individuals skinned
    uint32_t palette_served = 0;    // palettes reused
    uint32_t vertices_served = 0;   // vertices reused
    uint32_t on_demand = 0;         // skinned for this update alone: the geometry cache had no room
    uint32_t left_out = 0;          // not drawn: no memory to pose or skin them
    uint32_t deferred = 0;          // due, but left for a later update by the budget
    uint32_t overdue = 0;           // of these, poses older than two periods
    uint32_t over_budget = 0;       // evaluated beyond the budget: no pose was kept to show
    uint64_t evicted = 0;           // blocks evicted, since the caches were made
    uint64_t cache_bytes = 0;       // of blocks in use, now
    uint64_t cache_pool_bytes = 0;  // held from the host for them
    uint64_t arena_bytes = 0;       // held from the host for memory of single updates
    KeyPoseCounters key_poses;
};

class Caches
{
public:
    Caches(std::pmr::memory_resource *memory, const Settings &settings);
    ~Caches();
    Caches(const Caches &) = delete;
    Caches &operator=(const Caches &) = delete;

    // Makes room for the book-keeping of individuals in slots below `slot_count`, for the scratch of these templates,
    // and for the requests of the next update. The only call that may fail (std::bad_alloc); cached results stay.
    //   can_undo        whether updates may call undo()
    //   request_count   at most; none: as many as slots
    void reserve(uint32_t slot_count, base::Span<const model::Template *const> templates, bool can_undo = false,
                 uint32_t request_count = model::none);

    // An update calls these in this order. begin() returns an array to be filled with one request per candidate, within
    // its capacity.
    std::pmr::vector<Request> &begin(bool can_undo = false);
    // The same, but pending() keeps the requests of an earlier update: the caller overwrites all of them.
    void begin_over(bool can_undo);
    // Before animate(): puts back the requests of the last update. Until animate() begins, an update that can be undone
    // overwrites and frees nothing that the last one listed.
    void undo();
    // Finds memory for palettes, evicting the individuals unseen for longest, and lists those that are due.
    void allocate_poses();
    // Defers all but `pose_budget.budget` of the due poses whose earlier pose can still be shown (budget.cpp). The
    // deferred requests then name the cached pose.
    struct PoseBudget {
        double time_s = 0;
        double elapsed_s = 0;  // since the update before; 0: unknown
        uint32_t budget = 0;
    };
    void defer(const PoseBudget &pose_budget);
    void animate(const base::Jobs &jobs);
    void allocate_vertices();  // the same for vertices, of requests that are drawn
    void skin(const base::Jobs &jobs);

    // Between allocate_poses() and animate(): whether a request's pose must be evaluated.
    bool is_due(const Request &request) const;
    std::pmr::vector<Request> &pending() { return requests_; }

    // Vertices of a request of the last update; valid until the next begin(). None: not needed, or no memory.
    draw::Vertices vertices_of(const Request &request) const;
    // What these are skinned from; a null palette: key-poses, or parts placed by GL's matrix stack.
    static draw::Pose pose_of(const Request &request);
    // The palette of a request's pose, or null if there was no memory for it. When only the nodes' own matrices are
    // kept, the palette is made in the scratch of the slice, and the products for it are counted. `slice` is below
    // slice_count.
    const math::Affine *palette_for_spheres(const Request &request, uint32_t slice, uint64_t &products) const;
    // Of an individual whose parts are placed by GL's matrix stack; null otherwise.
    static const math::Affine *locals_of(const Request &request);
    static constexpr uint32_t slice_count = 64;  // tasks in an update, independent of the number of threads

    // The key of the palette that is kept in a slot, or null, and the radius that its request gave.
    const PoseKey *kept_pose(uint32_t slot) const
    {
        const Entry &entry = entries_[slot];
        return settings_.mode == Mode::none || !entry.palette ? nullptr : &entry.palette_key;
    }
    float kept_radius(uint32_t slot) const { return entries_[slot].palette_radius; }
    bool keeps_palette(uint32_t slot) const { return entries_[slot].palette; }
    bool keeps_vertices(uint32_t slot) const { return entries_[slot].vertices; }
    bool was_animated(uint32_t slot) const { return entries_[slot].animated_at == frame_number_; }
    base::Span<const Request> requests() const { return base::Span<const Request>(requests_); }
    const Counters &counters() const { return counters_; }
    uint64_t book_bytes() const;  // held besides palettes, vertices and key-poses
    const Settings &settings() const { return settings_; }
    const KeyPoses &key_poses() const { return key_poses_; }

private:
    struct Entry {
        const model::Template *tmpl = nullptr;  // determines the sizes of the blocks
        float *palette = nullptr;
        float *vertices = nullptr;
        PoseKey palette_key, vertices_key;
        float palette_radius = 0, vertices_radius = 0;  // Request::blend_radius that each was made for
        double shown_s = 0;                             // tick of the palette
        double renewed_s = 0;  // host's time at which it was made; only when updates have budgets
        uint32_t vertices_level = 0;
        uint32_t before = model::none, after = model::none;  // slots, see move_to_end()
        uint64_t last_seen = 0;
        uint64_t animated_at = 0;
    };
    using Block = float *Entry::*;

    // A due pose that may be deferred.
    struct Waiting {
        double periods;  // age of its pose in the next update, in periods
        float distance;
        uint32_t row, due;  // the latter indexes animate_
    };

    bool can_wait(const Request &request, double time_s) const;
    bool needs_vertices(const Request &request) const;
    void commit();
    bool is_listed(const Entry &entry) const { return entry.last_seen >= listed_from_; }
    void keep_pose(Entry &entry, const Request &request);
    void note_pose(uint32_t i, const Entry &entry);
    void note_vertices(uint32_t i, const Entry &entry);
    void skin(const Request &request, const Scratch &scratch);
    float *take(const Entry &wanted, Block kind);  // null: no room
    bool evict_one(uint64_t updates);
    void move_to_end(uint32_t slot);
    void release(Entry &entry, Block kind);
    size_t block_bytes(const model::Template &tmpl, Block kind) const;

    Settings settings_;
    BlockPool blocks_;
    FrameArena arena_;
    Counters counters_;
    uint64_t frame_number_ = 0;
    std::pmr::vector<Request> requests_;         // of the last update
    std::pmr::vector<Request> requests_before_;  // of the one before, while that can be undone
    std::pmr::vector<uint32_t> replaced_;        // requests of slots that were listed with another template
    uint64_t last_listed_ = 0;                   // number of the last update that was not undone
    uint64_t listed_from_ = ~uint64_t(0);  // individuals seen since then may still be drawn; none may: the maximum
    std::pmr::vector<Entry> entries_;      // by slot
    uint32_t without_room_ = 0;            // requests of the last update whose matrices no cache keeps
    std::pmr::vector<uint32_t> animate_;   // indices of requests
    std::pmr::vector<uint32_t> skin_;
    std::pmr::vector<Waiting> waiting_;
    PoseBudget pose_budget_;                             // of the last update
    uint32_t first_ = model::none, last_ = model::none;  // slots by when they were last seen
    std::pmr::vector<uint32_t> built_;                   // by slice: matrices built
    mutable ScratchPool scratch_;
    KeyPoses key_poses_;
};

}  // namespace claque::animcache
