/* clq_crowd_stats: what a crowd's last update did, what its caches hold, and the rates that were reached. */
#ifndef CLAQUE_CROWD_STATS_H
#define CLAQUE_CROWD_STATS_H

#include <claque/crowd.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Share of the update work that fell to actors at one distance. */
typedef struct clq_distance_band {
    float distance_min, distance_max; /* world units */
    uint64_t actor_frames;            /* actors seen in this band, summed over updates */
    double seconds;                   /* the same, in seconds of the host's clock */
    uint64_t animated;                /* poses evaluated for them */
} clq_distance_band;

#define CLQ_DISTANCE_BAND_COUNT 8

typedef struct clq_crowd_stats {
    uint32_t actor_count;
    uint32_t groups;         /* that have members */
    uint32_t groups_visible; /* of these, enabled and met by a view of the last update */
    uint32_t tested;         /* actors without a group, and members of visible groups: whose own spheres were tested */
    /* S0 4.2: of these, in any view, who passed the first and the second cull phase, and who of them crossed a frustum's
     * edge, so that its parts were tested one by one in the third. */
    uint32_t passed_refpoint, passed_sklsroot, crossing;
    uint64_t sphere_tests;       /* spheres against frustums, in all phases */
    uint64_t spheres_built;      /* Internal Bspheres */
    uint64_t roots_placed;       /* Skeleton Roots */
    uint64_t distances;          /* from an eye */
    uint64_t matrices_needed;    /* nodes at the levels of who passed the second phase */
    uint64_t matrices_built;     /* of these, anew: fCoh is their share (S0 6.2.2) */
    uint64_t products;           /* of matrices, for who is drawn or tested by parts */
    uint64_t products_tracked;   /* of these, made by claque and not by GL: fTrack is their share */
    uint64_t behaviour_calls[6]; /* of mechanisms, by clq_mechanism_kind */
    uint64_t dof_writes;
    uint32_t visible;         /* in the last update, in any view */
    uint32_t due;             /* of these, whose pose was due; deferred ones included */
    uint32_t animated;        /* poses evaluated */
    uint32_t skinned;         /* individuals skinned */
    uint32_t palette_served;  /* from the animation cache */
    uint32_t vertices_served; /* from the geometry cache */
    uint32_t on_demand;       /* left for the drawing to skin: no room in the cache */
    uint32_t deferred;        /* due, but left for a later update by the budget */
    uint32_t overdue;         /* of these, who keep a pose for more than two periods: the budget is too small */
    uint32_t over_budget;     /* poses evaluated beyond the budget, because there was none to show */
    uint64_t evicted;         /* entries thrown out since the crowd was made */
    uint64_t cache_bytes, cache_budget_bytes;
    uint64_t cache_pool_bytes; /* that the allocator has given for the former: at most the budget */
    uint64_t actor_bytes;      /* of all actors besides the caches */
    clq_distance_band bands[CLQ_DISTANCE_BAND_COUNT]; /* since the crowd was made, or since clq_crowd_reset_bands */
} clq_crowd_stats;

CLQ_API clq_status clq_crowd_get_stats(const clq_crowd *crowd, clq_crowd_stats *out);
CLQ_API clq_status clq_crowd_reset_bands(clq_crowd *crowd);

/* A fingerprint of everything a host has set in the crowd; two crowds made by the same calls have the same. */
CLQ_API uint64_t clq_crowd_hash(const clq_crowd *crowd);

#ifdef __cplusplus
}
#endif

#endif
