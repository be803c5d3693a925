/* clq_crowd_stats: the work of a crowd's last update, the contents of its caches, and the update rates it reached. */
#ifndef CLAQUE_CROWD_STATS_H
#define CLAQUE_CROWD_STATS_H

#include <claque/crowd.h>

#ifdef __cplusplus
extern "C" {
#endif

/* The update work for actors at eyeDistances in [distance_min_m, distance_max_m). */
typedef struct clq_distance_band {
    float distance_min_m, distance_max_m;
    uint64_t actor_frames; /* visible actors in the band, summed over updates */
    double seconds;        /* the same sum, in seconds of the host's clock */
    uint64_t animated;     /* poses evaluated for them */
} clq_distance_band;

#define CLQ_DISTANCE_BAND_COUNT 8

typedef struct clq_crowd_stats {
    uint32_t struct_bytes; /* set by clq_crowd_stats_init */
    uint32_t actor_count;
    uint32_t groups;         /* groups that have members */
    uint32_t groups_visible; /* of these, groups that are enabled and met by a view of the last update */
    uint32_t tested;         /* actors whose own spheres were tested: without a group, or in a visible group */
    /* Of the tested actors (S0 4.2): those that passed the first cull phase in any view; those that passed the second;
     * of the latter those that crossed a side of a frustum, so that the third phase tested their parts. */
    uint32_t passed_refpoint, passed_sklsroot, crossing;
    uint64_t sphere_tests;       /* tests of a sphere against a frustum, in all phases */
    uint64_t spheres_built;      /* Internal Bspheres */
    uint64_t roots_placed;       /* Skeleton Roots */
    uint64_t distances;          /* distances to an eye */
    uint64_t matrices_needed;    /* nodes at the levels of the actors that passed the second phase */
    uint64_t matrices_built;     /* of these, computed anew: their share is fCoh (S0 6.2.2) */
    uint64_t products;           /* matrix products for actors that are drawn or tested by parts */
    uint64_t products_tracked;   /* of these, computed by claque and not by GL: their share is fTrack */
    uint64_t behaviour_calls[6]; /* calls of mechanisms, by clq_mechanism_kind */
    uint64_t dof_writes;         /* writes of degrees of freedom */
    uint32_t visible;            /* actors visible in any view of the last update */
    uint32_t due;                /* of these, actors whose pose was due, deferred ones included */
    uint32_t animated;           /* poses evaluated */
    uint32_t skinned;            /* individuals skinned */
    uint32_t palette_served;     /* individuals served from the animation cache */
    uint32_t vertices_served;    /* individuals served from the geometry cache */
    uint32_t on_demand;          /* individuals skinned for this update alone, without room in the caches */
    uint32_t deferred;           /* due poses that the budget left for a later update */
    uint32_t overdue;            /* of these, poses kept for more than two periods: the budget is too small */
    uint32_t over_budget;        /* poses evaluated beyond the budget, because none was kept to show */
    uint64_t evicted;            /* cache entries evicted since the crowd was created */
    uint64_t cache_bytes, cache_budget_bytes;
    uint64_t cache_pool_bytes; /* memory taken from the allocator for the caches, at most the budget */
    uint64_t actor_bytes;      /* memory of all actors without the caches */
    clq_distance_band bands[CLQ_DISTANCE_BAND_COUNT]; /* since the crowd was created or clq_crowd_reset_bands */
    uint64_t frame_bytes; /* memory of updates besides the caches, key-poses and views; contains arena_bytes */
    uint64_t arena_bytes; /* memory of palettes and vertices that no cache keeps, at the fullest update */
    uint32_t left_out;    /* visible individuals without vertices, because the allocator refused memory */
} clq_crowd_stats;

CLQ_DEFINE_ZERO_INIT(clq_crowd_stats)

/* Gets the statistics of a crowd.
 *   out   made by clq_crowd_stats_init
 * Fails: STRUCT_SIZE, ARGUMENT, BUSY. Threads: any. GL: none. */
CLQ_API clq_status clq_crowd_get_stats(const clq_crowd *crowd, clq_crowd_stats *out);

/* Sets the sums of all distance bands to 0. Fails: ARGUMENT, BUSY. Threads: the crowd's writer. GL: none. */
CLQ_API clq_status clq_crowd_reset_bands(clq_crowd *crowd);

#ifdef __cplusplus
}
#endif

#endif
