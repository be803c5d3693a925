/* clq_crowd and clq_actor: who is there, where, doing what, in what colours; and the update that animates what can be
 * seen.
 *
 * A crowd has one writer: calls that change it come from one thread at a time. Positions are doubles and drawn relative
 * to the eye, so that a world of 10^6 m does not shake. Actors are {index, generation} ids by value: zero is none, and
 * an id whose actor is gone is STALE_ID for ever. */
#ifndef CLAQUE_CROWD_H
#define CLAQUE_CROWD_H

#include <claque/key_poses.h>
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

/* An object that an actor holds, an id by value: see clq_actor_attach. */
typedef struct clq_attachment {
    uint32_t index1;
    uint32_t generation;
} clq_attachment;

/* Called by clq_renderer_draw before and after one individual is drawn (S0 7.1), on its thread, with its context current.
 * before() may bind a two-dimensional texture of the host's own, with the template's zone keys in its alpha, and returns 1 to
 * have it used in place of the template's; else 0. What lights, fog or material it sets act on this individual. Nothing
 * that either leaves in GL reaches the next. They may call nothing of claque. Either may be NULL. */
typedef struct clq_actor_hooks {
    int32_t (*before)(void *user, clq_actor actor);
    void (*after)(void *user, clq_actor actor);
    void *user;
} clq_actor_hooks;

/* How actors are culled (S0 4). The picture is the same. */
typedef enum clq_cull_mode {
    CLQ_CULL_ACTOR = 0,      /* in three phases, behaviour between them, for who is left (S0 4.2) */
    CLQ_CULL_TRADITIONAL = 1 /* everything is computed for everybody in every update, nothing kept, and culled
                                last: for comparison */
} clq_cull_mode;

/* Where rigid parts get their matrices (S0 6.2.2, fTrack). The picture is the same but for GL's own rounding. */
typedef enum clq_rigid_mode {
    CLQ_RIGID_VERTICES = 0, /* claque moves the vertices */
    CLQ_RIGID_MATRICES = 1  /* GL's matrix stack does, for templates of rigid parts alone; others as above */
} clq_rigid_mode;

/* What is kept from frame to frame (S1 4). It changes what a frame costs, never what it shows. */
typedef enum clq_cache_mode {
    CLQ_CACHE_FULL = 0,      /* matrix palettes, and skinned positions and normals */
    CLQ_CACHE_ANIMATION = 1, /* matrix palettes; skinned anew each frame */
    CLQ_CACHE_NONE = 2       /* nothing */
} clq_cache_mode;

/* How skinned vertices are kept and handed to GL. Packed: positions as GL_SHORT in steps of the template's Sklsroot
 * radius / 32767, so that a vertex is wrong by half a step along each axis at most (0.03 mm for a person), and normals
 * as GL_BYTE, wrong by 0.4 degrees at most. */
typedef enum clq_vertex_format {
    CLQ_VERTEX_FLOAT = 0, /* 24 bytes a vertex */
    CLQ_VERTEX_PACKED = 1 /* 12 bytes a vertex */
} clq_vertex_format;

/* Whether what is shown may have a memory. Live, nobody shows an earlier tick than it has shown, so that nobody steps back
 * when the camera recedes; an update whose time is before that of the last one forgets what was shown. */
typedef enum clq_clock {
    CLQ_CLOCK_REFERENCE = 0, /* no: a function of time and distance, any frame is the same by itself */
    CLQ_CLOCK_LIVE = 1
} clq_clock;

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
    clq_cull_mode cull;
    clq_rigid_mode rigid_mode;
    /* S0 5: an actor's level of detail follows its effective distance: eyeDistance times 1 - priority, times how much
     * smaller than at home a thing looks in the view (clq_view_set_height). */
    float lod_scale; /* [>= 0] times every effective distance; 0 everything at its finest. Default 1 */
    float
        lod_hysteresis; /* [0, 1) share of a switch distance that must be passed on the way back. Default 0: none, so that
                             what is shown has no memory */
    clq_vertex_format vertex_format;
    clq_clock clock;
    /* With CLQ_CLOCK_LIVE and a cache: how many poses an update renews at most. 0: all that are due. Who must wait shows
     * its last pose; first go those who would keep one for nearly twice their period, then the near ones. Who has no
     * pose yet, or one of another clip, is posed whatever the budget: see over_budget and overdue in clq_crowd_stats. */
    uint32_t update_budget;
    /* The same in milliseconds of posing and skinning, by what a pose has cost in the updates before; the lower of
     * both holds. 0: no limit. What is shown then depends on how fast the machine is. Needs now_s. */
    float update_budget_ms;      /* [>= 0] */
    double (*now_s)(void *user); /* seconds that never run back; called in clq_crowd_update, on its thread */
    void *now_user;
    clq_key_poses key_poses; /* who shares skinned key-poses instead (S3). Default: nobody */
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
    def.cull = CLQ_CULL_ACTOR;
    def.rigid_mode = CLQ_RIGID_VERTICES;
    def.lod_scale = 1.0f;
    def.lod_hysteresis = 0.0f;
    def.vertex_format = CLQ_VERTEX_FLOAT;
    def.clock = CLQ_CLOCK_REFERENCE;
    def.update_budget = 0;
    def.update_budget_ms = 0.0f;
    def.now_s = NULL;
    def.now_user = NULL;
    def.key_poses = clq_key_poses_init();
    return def;
}

/* Makes an empty crowd.  def: copied; NULL means the init values.  out: [owner: host, until clq_crowd_destroy]
 * Fails: STRUCT_SIZE, ARGUMENT, OUT_OF_MEMORY. Threads: any. GL: none. */
CLQ_API clq_status clq_crowd_create(clq_context *context, const clq_crowd_def *def, clq_crowd **out);

/* Ends a crowd, its actors and its views; NULL is ignored. Renderers live on. */
CLQ_API void clq_crowd_destroy(clq_crowd *crowd);

/* Where an actor's Reference Point is. */
typedef struct clq_transform {
    double position[3];
    float orientation_xyzw[4]; /* unit within 0.001; all zero means no rotation */
    float scale;               /* finite, not 0; negative mirrors. 0 means 1 */
} clq_transform;

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
    clq_transform transform;
    clq_play play;
    uint64_t seed;        /* of this individual's draws by lot, with the crowd's seed; equal seeds are twins */
    uint32_t texture_set; /* as clq_actor_set_texture_set takes it. Default 0 */
} clq_actor_def;

static inline clq_actor_def clq_actor_def_init(void)
{
    clq_actor_def def;
    def.struct_bytes = (uint32_t)sizeof def;
    def.tmpl = NULL;
    def.transform.position[0] = def.transform.position[1] = def.transform.position[2] = 0.0;
    def.transform.orientation_xyzw[0] = def.transform.orientation_xyzw[1] = def.transform.orientation_xyzw[2] = 0.0f;
    def.transform.orientation_xyzw[3] = 1.0f;
    def.transform.scale = 1.0f;
    def.play.clip = CLQ_NONE;
    def.play.start_s = 0.0;
    def.play.speed = 1.0f;
    def.play.phase_s = 0.0f;
    def.seed = 0;
    def.texture_set = 0;
    return def;
}

#define CLQ_RANDOM 0xffffffffu /* drawn by the seeds of crowd and actor */

/* Adds an individual; it shows its template's zone colours until it is given its own. Costs its own state only
 * (S0 7.1). Fails: STRUCT_SIZE, ARGUMENT, LIMIT, OUT_OF_MEMORY. Threads: the crowd's writer. GL: none. */
CLQ_API clq_status clq_actor_create(clq_crowd *crowd, const clq_actor_def *def, clq_actor *out);

/* Takes an individual out. Fails: STALE_ID. Threads: the crowd's writer. */
CLQ_API clq_status clq_actor_destroy(clq_crowd *crowd, clq_actor actor);

/* Starts a clip. Fails: STALE_ID, ARGUMENT (clip of another template, not finite). Threads: the crowd's writer. */
CLQ_API clq_status clq_actor_play(clq_crowd *crowd, clq_actor actor, const clq_play *play);

/* Places `count` actors at once; all or none. Fails: STALE_ID (naming the first), ARGUMENT. Threads: the crowd's
 * writer. */
CLQ_API clq_status clq_crowd_set_transforms(clq_crowd *crowd, const clq_actor *actors, const clq_transform *transforms,
                                            uint32_t count);

/* Gives an individual its colours, one RGB a zone of its template, as glColor takes them, rounded to 8 bits.
 *   rgb   [3 * zone_count], each [0, 1]
 * Fails: STALE_ID, ARGUMENT, OUT_OF_MEMORY. Threads: the crowd's writer. Seed: S1 3. */
CLQ_API clq_status clq_actor_set_colours(clq_crowd *crowd, clq_actor actor, const float *rgb, uint32_t zone_count);

/* Draws an individual's colours from HSB ranges, repeatably from its seed (S2 5).
 *   ranges   [zone_count], or NULL with zone_count 0: the template's own ranges
 * Fails: as above. */
CLQ_API clq_status clq_actor_randomise_colours(clq_crowd *crowd, clq_actor actor, const clq_hsb_range *ranges,
                                               uint32_t zone_count);

/* Which of its template's texture sets an individual shows (S1 1): 0 ... texture_set_count - 1 of clq_template_info, or
 * CLQ_RANDOM. Fails: STALE_ID, ARGUMENT. Threads: the crowd's writer. */
CLQ_API clq_status clq_actor_set_texture_set(clq_crowd *crowd, clq_actor actor, uint32_t set);

/* Adds an individual like another one: its template, clip, colours, texture set, mechanisms with their commands, way of the Skeleton
 * Root, group, priority, hooks, ground; not what is attached to it (S0 7.1). Nothing of the template is copied.
 *   place   in the other's group, if it has one; NULL: the other's own
 *   seed    of its draws by lot from now on; its colours are those of the other until they are drawn anew
 * Fails: STALE_ID, ARGUMENT, LIMIT, OUT_OF_MEMORY. Threads: the crowd's writer. GL: none. */
CLQ_API clq_status clq_actor_clone(clq_crowd *crowd, clq_actor actor, const clq_transform *transform, uint64_t seed,
                                   clq_actor *out);

/* S0 5: raises the detail of who matters: 0 as its distance says ... 1 always the finest. Of levels of detail and
 * behaviour; the update rate does not follow it. Fails: STALE_ID, ARGUMENT. Threads: the crowd's writer. */
CLQ_API clq_status clq_actor_set_priority(clq_crowd *crowd, clq_actor actor, float priority);

/* Attaches an object of the host's scene to a node (S0 4.3): the actor's bounding spheres grow so that they hold it, in
 * every pose, and shrink when it goes. Claque draws nothing for it; clq_actor_get_node says where it is.
 *   centre, radius   of the object's bounding sphere in the node's frame
 *   out              may be NULL
 * Ends with the actor. Fails: STALE_ID, ARGUMENT, OUT_OF_MEMORY. Threads: the crowd's writer. */
CLQ_API clq_status clq_actor_attach(clq_crowd *crowd, clq_actor actor, uint32_t node, const float centre[3],
                                    float radius, clq_attachment *out);
CLQ_API clq_status clq_actor_detach(clq_crowd *crowd, clq_attachment attachment);

/* Where a node is in the world: column-major, to be multiplied from the left.
 *   time_s   the pose of this moment, evaluated anew; NaN: the pose that the last update showed (its tick), which is
 *            rigidly carried by the Reference Point and the Skeleton Root as they were then
 * Of an actor that the last update did not see, NaN gives the pose of its time at the finest level.
 * Host mechanisms are not run for it. Fails: STALE_ID, ARGUMENT, OUT_OF_MEMORY. Threads: the crowd's writer. */
CLQ_API clq_status clq_actor_get_node(clq_crowd *crowd, clq_actor actor, uint32_t node, double time_s,
                                      double out_matrix[16]);

/* Callbacks round the drawing of one actor; copied. NULL: none. Fails: STALE_ID, OUT_OF_MEMORY. Threads: the crowd's
 * writer. */
CLQ_API clq_status clq_actor_set_hooks(clq_crowd *crowd, clq_actor actor, const clq_actor_hooks *hooks);

typedef struct clq_actor_info {
    const clq_template *tmpl;
    clq_transform transform;
    clq_group group; /* that it is a member of, and in whose space its place is given; {0, 0}: none */
    clq_play play;
    uint64_t seed;
    int32_t visible; /* 1: seen by a view in the last update */
    float period_s;  /* of the last update in which it was seen */
    double tick_s;   /* time of the pose it showed then */
    float priority;
    float eye_distance; /* of the last update that saw it: from its Skeleton Root to the nearest eye, world units */
    uint32_t level;     /* of detail, then */
    clq_transform root; /* where its Skeleton Root was in the world then; else where its Reference Point is */
    /* S0 4.1: of its bounding spheres now, at scale 1, with its way and what is attached to it. */
    float refpoint_radius, sklsroot_radius;
    uint32_t texture_set;
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

#ifdef __cplusplus
}
#endif

#include <claque/crowd_stats.h>

#endif
