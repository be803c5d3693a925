/* clq_crowd and clq_actor: who is there, where, doing what, in what colours; and the update that animates what can be
 * seen.
 *
 * A crowd has one writer: calls that change it come from one thread at a time. Positions are doubles and drawn relative
 * to the eye, so that a world of 10^6 m does not shake. Actors are {index, generation} ids by value: zero is none, and
 * an id whose actor is gone is STALE_ID for ever. */
#ifndef CLAQUE_CROWD_H
#define CLAQUE_CROWD_H

#include <claque/template.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef struct clq_crowd clq_crowd;
typedef struct clq_view clq_view;

typedef struct clq_actor {
    uint32_t index1;
    uint32_t generation;
} clq_actor;

/* A group of actors, an id by value like theirs: see claque/group.h. */
typedef struct clq_group {
    uint32_t index1;
    uint32_t generation;
} clq_group;

/* What is kept from frame to frame (S1 4). It changes what a frame costs, never what it shows. */
typedef enum clq_cache_mode {
    CLQ_CACHE_FULL = 0,      /* matrix palettes, and skinned positions and normals */
    CLQ_CACHE_ANIMATION = 1, /* matrix palettes; skinned anew each frame */
    CLQ_CACHE_NONE = 2       /* nothing */
} clq_cache_mode;

typedef struct clq_crowd_def {
    uint32_t struct_bytes; /* set by clq_crowd_def_init */
    clq_cache_mode cache;
    uint64_t cache_budget_bytes; /* palettes and vertices together; 0: 1 GiB. Who finds no room is skinned when drawn */
    /* The update period: linear in the squared distance to the eye, rounded down to 1/50 ... 1/4 s. */
    float period_near_s;   /* [0, 1] at distance_near or nearer; 0: every frame. Default 0.02 */
    float period_far_s;    /* [>= period_near_s] at distance_far or farther. Default 0.25 */
    float distance_near;   /* [>= 0] in world units. Default 5 m */
    float distance_far;    /* [> distance_near]. Default 50 m */
    float metres_per_unit; /* [> 0] of world positions; distances above are in units. Default 1 */
    uint64_t seed;         /* of everything that is drawn by lot in this crowd */
} clq_crowd_def;

static inline clq_crowd_def clq_crowd_def_init(void)
{
    clq_crowd_def def;
    def.struct_bytes = (uint32_t)sizeof def;
    def.cache = CLQ_CACHE_FULL;
    def.cache_budget_bytes = 0;
    def.period_near_s = 0.02f;
    def.period_far_s = 0.25f;
    def.distance_near = 5.0f;
    def.distance_far = 50.0f;
    def.metres_per_unit = 1.0f;
    def.seed = 0;
    return def;
}

/* Makes an empty crowd.  def: copied; NULL means the init values.  out: [owner: host, until clq_crowd_destroy]
 * Fails: STRUCT_SIZE, ARGUMENT, OUT_OF_MEMORY. Threads: any. GL: none. */
CLQ_API clq_status clq_crowd_create(clq_context *context, const clq_crowd_def *def, clq_crowd **out);

/* Ends a crowd, its actors and its views; NULL is ignored. Renderers live on. */
CLQ_API void clq_crowd_destroy(clq_crowd *crowd);

/* Where an actor's Reference Point is. */
typedef struct clq_place {
    double position[3];
    float orientation_xyzw[4]; /* unit within 0.001; all zero means no rotation */
    float scale;               /* finite, not 0; negative mirrors. 0 means 1 */
} clq_place;

/* A clip and its clock: at time t the clip stands at phase_s + speed * (t - start_s), looping. */
typedef struct clq_play {
    uint32_t clip;  /* of the actor's template; CLQ_NONE: the rest pose */
    double start_s; /* on the clock of clq_crowd_update */
    float speed;    /* finite; negative plays backwards, 0 stands still */
    float phase_s;  /* finite */
} clq_play;

typedef struct clq_actor_def {
    uint32_t struct_bytes; /* set by clq_actor_def_init */
    clq_template *tmpl;    /* held until the crowd goes */
    clq_place place;
    clq_play play;
    uint64_t seed; /* of this individual's draws by lot, with the crowd's seed; equal seeds are twins */
} clq_actor_def;

static inline clq_actor_def clq_actor_def_init(void)
{
    clq_actor_def def;
    def.struct_bytes = (uint32_t)sizeof def;
    def.tmpl = NULL;
    def.place.position[0] = def.place.position[1] = def.place.position[2] = 0.0;
    def.place.orientation_xyzw[0] = def.place.orientation_xyzw[1] = def.place.orientation_xyzw[2] = 0.0f;
    def.place.orientation_xyzw[3] = 1.0f;
    def.place.scale = 1.0f;
    def.play.clip = CLQ_NONE;
    def.play.start_s = 0.0;
    def.play.speed = 1.0f;
    def.play.phase_s = 0.0f;
    def.seed = 0;
    return def;
}

/* Adds an individual; it shows its template's zone colours until it is given its own. Costs its own state only
 * (S0 7.1). Fails: STRUCT_SIZE, ARGUMENT, LIMIT, OUT_OF_MEMORY. Threads: the crowd's writer. GL: none. */
CLQ_API clq_status clq_actor_create(clq_crowd *crowd, const clq_actor_def *def, clq_actor *out);

/* Takes an individual out. Fails: STALE_ID. Threads: the crowd's writer. */
CLQ_API clq_status clq_actor_destroy(clq_crowd *crowd, clq_actor actor);

/* Starts a clip. Fails: STALE_ID, ARGUMENT (clip of another template, not finite). Threads: the crowd's writer. */
CLQ_API clq_status clq_actor_play(clq_crowd *crowd, clq_actor actor, const clq_play *play);

/* Places `count` actors at once; all or none. Fails: STALE_ID (naming the first), ARGUMENT. Threads: the crowd's
 * writer. */
CLQ_API clq_status clq_crowd_place(clq_crowd *crowd, const clq_actor *actors, const clq_place *places, uint32_t count);

/* Gives an individual its colours, one RGB a zone of its template, as glColor takes them, rounded to 8 bits.
 *   rgb   [3 * zone_count], each [0, 1]
 * Fails: STALE_ID, ARGUMENT, OUT_OF_MEMORY. Threads: the crowd's writer. Seed: S1 3. */
CLQ_API clq_status clq_actor_set_colours(clq_crowd *crowd, clq_actor actor, const float *rgb, uint32_t zone_count);

/* Draws an individual's colours from HSB ranges, repeatably from its seed (S2 5).
 *   ranges   [zone_count], or NULL with zone_count 0: the template's own ranges
 * Fails: as above. */
CLQ_API clq_status clq_actor_draw_colours(clq_crowd *crowd, clq_actor actor, const clq_hsb_range *ranges,
                                          uint32_t zone_count);

typedef struct clq_actor_info {
    const clq_template *tmpl;
    clq_place place;
    clq_group group; /* that it is a member of, and in whose space its place is given; {0, 0}: none */
    clq_play play;
    uint64_t seed;
    int32_t visible; /* 1: seen by a view in the last update */
    float period_s;  /* of the last update in which it was seen */
    double shown_s;  /* time of the pose it showed then */
} clq_actor_info;

CLQ_API clq_status clq_actor_get_info(const clq_crowd *crowd, clq_actor actor, clq_actor_info *out);

/* How many there are. Threads: any, not during an update. */
CLQ_API uint32_t clq_crowd_actor_count(const clq_crowd *crowd);

/* One frame: places, culls, finds who is due, animates and skins them, and makes each view's draw list (S0 4.2, S1 4).
 *   time_s   the host's clock; may jump, also back. What is shown is a function of it and the distances
 *   views    [view_count] of this crowd; the others' lists become empty
 * Fails: ARGUMENT, LIMIT, BUSY, OUT_OF_MEMORY; crowd and lists are then as they were. Threads: the crowd's writer;
 * spreads over the context's tasks. GL: none. */
CLQ_API clq_status clq_crowd_update(clq_crowd *crowd, double time_s, clq_view *const *views, uint32_t view_count);

/* Share of the update work that fell to actors at one distance. */
typedef struct clq_band {
    float distance_first, distance_last; /* world units */
    uint64_t actor_frames;               /* actors seen in this band, summed over updates */
    double seconds;                      /* the same, in seconds of the host's clock */
    uint64_t animated;                   /* poses evaluated for them */
} clq_band;

#define CLQ_BAND_COUNT 8

typedef struct clq_crowd_stats {
    uint32_t actor_count;
    uint32_t groups;          /* that have members */
    uint32_t groups_visible;  /* of these, enabled and met by a view of the last update */
    uint32_t tested;          /* actors without a group, and members of visible groups: whose own spheres were tested */
    uint32_t visible;         /* in the last update, in any view */
    uint32_t due;             /* of these, whose pose was due */
    uint32_t animated;        /* poses evaluated */
    uint32_t skinned;         /* individuals skinned */
    uint32_t palette_served;  /* from the animation cache */
    uint32_t vertices_served; /* from the geometry cache */
    uint32_t on_demand;       /* left for the drawing to skin: no room in the cache */
    uint64_t evicted;         /* entries thrown out since the crowd was made */
    uint64_t cache_bytes, cache_budget_bytes;
    uint64_t actor_bytes;           /* of all actors besides the caches */
    clq_band bands[CLQ_BAND_COUNT]; /* since the crowd was made, or since clq_crowd_reset_bands */
} clq_crowd_stats;

CLQ_API clq_status clq_crowd_get_stats(const clq_crowd *crowd, clq_crowd_stats *out);
CLQ_API clq_status clq_crowd_reset_bands(clq_crowd *crowd);

/* A fingerprint of everything a host has set in the crowd; two crowds made by the same calls have the same. */
CLQ_API uint64_t clq_crowd_fingerprint(const clq_crowd *crowd);

#ifdef __cplusplus
}
#endif

#endif
