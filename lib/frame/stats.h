// What an update did, for hosts and tests; nothing reads it to decide anything.
#pragma once

#include "animcache/keyposes.h"
#include "lib/behave/behave.h"

#include <cstdint>

namespace claque::frame
{

constexpr uint32_t band_count = 8;

// What fell to individuals at one distance, since the counters were reset. animated / seconds is the rate reached.
struct Band {
    float distance_min = 0, distance_max = 0;  // world units; the last band is open
    uint64_t actor_frames = 0;                 // individuals seen, summed over updates
    double seconds = 0;     // of the host's clock, between updates that both saw the individual and were < 1 s apart
    uint64_t animated = 0;  // poses evaluated in that time
};

struct Stats {
    uint32_t groups = 0;          // that have members
    uint32_t groups_visible = 0;  // of these, enabled and met by a view
    uint32_t tested = 0;          // actors without a group, and members of groups seen: phase 1
    // S0 4.2, in any view: who passed phase 1 and phase 2, and who then crossed a frustum's edge.
    uint32_t passed_refpoint = 0, passed_sklsroot = 0, crossing = 0;
    uint64_t sphere_tests = 0;      // against a frustum, all three phases (S0 table 1: NO_04b)
    uint64_t spheres_built = 0;     // Internal Bspheres (NO_04a)
    uint64_t roots_placed = 0;      // Skeleton Roots (NO_03)
    uint64_t distances = 0;         // to an eye (NO_05)
    uint64_t matrices_needed = 0;   // nodes evaluated at the levels of who was asked for
    uint64_t matrices_built = 0;    // of these, anew (NO_01; fCoh is their share)
    uint64_t products = 0;          // of matrices, needed for who is drawn
    uint64_t products_tracked = 0;  // of these, made here and not by GL (fTrack is their share)
    behave::Counts behaviour;
    uint32_t visible = 0;          // in any view
    uint32_t due = 0;              // of these, whose palette held was not that of their tick
    uint32_t animated = 0;         // poses evaluated
    uint32_t skinned = 0;          // individuals skinned
    uint32_t palette_served = 0;   // palettes used again
    uint32_t vertices_served = 0;  // vertices used again
    uint32_t on_demand = 0;        // left for the drawing: no room
    uint32_t deferred = 0;         // due, but left for a later update by the budget
    uint32_t overdue = 0;          // of these, who keep a pose for more than two periods
    uint32_t over_budget = 0;      // evaluated beyond the budget: there was no pose to show
    uint64_t evicted = 0;          // blocks thrown out, since the caches were made
    uint64_t cache_bytes = 0, cache_budget_bytes = 0;
    uint64_t cache_pool_bytes = 0;  // that the host has given for the former
    animcache::KeyPoseCounters key_poses;
    Band bands[band_count];
};

}  // namespace claque::frame
