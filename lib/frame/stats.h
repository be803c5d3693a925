// Statistics of an update for hosts and tests. The library never reads them.
#pragma once

#include <cstdint>

#include "animcache/caches.h"
#include "lib/behave/behave.h"

namespace claque::frame
{

constexpr uint32_t band_count = 8;

// Totals of individuals at one range of distances, since the counters were reset. animated / seconds is the achieved
// rate.
struct Band {
    float distance_min = 0, distance_max = 0;  // world units; the last band has no upper end
    uint64_t actor_frames = 0;                 // visible individuals, summed over updates
    double seconds = 0;     // of the host's clock, between updates that both saw the individual and were < 1 s apart
    uint64_t animated = 0;  // poses evaluated in that time
};

struct Stats : animcache::Counters {
    uint32_t groups = 0;          // that have members
    uint32_t groups_visible = 0;  // of these, enabled and met by a view
    uint32_t tested = 0;          // phase 1: actors without a group, and members of visible groups
    // S0 4.2, in any view: actors that passed phase 1, that passed phase 2, and that crossed a frustum's edge then.
    uint32_t passed_refpoint = 0, passed_sklsroot = 0, crossing = 0;
    uint64_t sphere_tests = 0;      // against a frustum, all three phases (S0 table 1: NO_04b)
    uint64_t spheres_built = 0;     // Internal Bspheres (NO_04a)
    uint64_t roots_placed = 0;      // Skeleton Roots (NO_03)
    uint64_t distances = 0;         // to an eye (NO_05)
    uint64_t matrices_needed = 0;   // nodes evaluated at the levels of requested individuals
    uint64_t products = 0;          // of matrices, needed for drawn individuals
    uint64_t products_tracked = 0;  // of these, made on the CPU and not by GL (fTrack is their share)
    behave::Counts behaviour;
    uint32_t visible = 0;  // in any view
    uint64_t cache_budget_bytes = 0;
    uint64_t frame_bytes = 0;  // held by updates besides caches and key-poses; includes arena_bytes
    Band bands[band_count];
};

}  // namespace claque::frame
