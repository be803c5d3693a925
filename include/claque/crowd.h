/* clq_crowd and clq_actor: individuals, where they are, what they play and their colours; and the update that animates
 * the visible ones.
 *
 * A crowd has one writer: calls that change it come from one thread at a time. Calls that get something of it or of its
 * views, or draw them, may come from any thread. claque never waits: a call that meets a change, or a change that meets
 * a call, fails with BUSY and does nothing. This also holds for calls that a callback makes. Only a call that destroys
 * an object must not meet another one for it.
 *
 * Positions are doubles and are drawn relative to the eye, so they do not jitter at 10^6 m from the origin. An actor is
 * an {index, generation} id by value. {0, 0} is no actor. The id of a destroyed actor is STALE_ID for ever. */
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

/* The id of a group of actors, see claque/group.h. */
typedef struct clq_group {
    uint32_t index1;
    uint32_t generation;
} clq_group;

/* The id of an object that an actor carries, see clq_actor_attach. */
typedef struct clq_attachment {
    uint32_t index1;
    uint32_t generation;
} clq_attachment;

/* Callbacks around the drawing of one individual (S0 7.1). clq_renderer_draw calls them on its thread with its GL
 * context current. Either may be NULL. They must not call claque. claque/renderer.h says what they may do in GL.
 * An individual whose hook `before` throws an exception is not drawn; the others are, and the draw then fails with
 * CALLBACK. */
typedef struct clq_actor_hooks {
    /* Returns true if it has bound a two-dimensional texture of the host, with the template's zone keys in its alpha,
     * to be used in place of the template's. Lights, fog and materials that it sets act on this individual alone. */
    bool (*before)(void *user, clq_actor actor);
    void (*after)(void *user, clq_actor actor);
    void *user;
} clq_actor_hooks;

/* How actors are culled (S0 4). All modes give the same picture. */
typedef enum clq_cull_mode {
    /* Three cull phases. Behaviour is computed between them, for the actors that remain (S0 4.2). */
    CLQ_CULL_ACTOR = 0,
    /* For comparison: every update computes everything for all actors, keeps nothing, and culls last. */
    CLQ_CULL_TRADITIONAL = 1
} clq_cull_mode;

/* How the matrices of rigid parts are applied (S0 6.2.2, fTrack). The pictures agree up to GL's rounding. */
typedef enum clq_rigid_mode {
    CLQ_RIGID_VERTICES = 0, /* claque transforms the vertices */
    CLQ_RIGID_MATRICES = 1  /* GL's matrix stack does, for templates that have only rigid parts */
} clq_rigid_mode;

/* What is kept from frame to frame (S1 4). The mode changes the cost of a frame, never its picture. */
typedef enum clq_cache_mode {
    CLQ_CACHE_FULL = 0,      /* matrix palettes, and skinned positions and normals */
    CLQ_CACHE_ANIMATION = 1, /* matrix palettes; vertices are skinned in every frame */
    CLQ_CACHE_NONE = 2       /* nothing */
} clq_cache_mode;

/* The format of skinned vertices in caches and in GL. Packed positions are GL_SHORT in steps of the template's Sklsroot
 * radius / 32767, so each coordinate is off by half a step at most (0.03 mm for a person). Packed normals are GL_BYTE,
 * off by 0.4 degrees at most. */
typedef enum clq_vertex_format {
    CLQ_VERTEX_FLOAT = 0, /* 24 bytes per vertex */
    CLQ_VERTEX_PACKED = 1 /* 12 bytes per vertex */
} clq_vertex_format;

/* The rule for shown ticks. */
typedef enum clq_clock {
    /* A tick is a function of time and distance. Any frame can be computed by itself. */
    CLQ_CLOCK_REFERENCE = 0,
    /* An actor also never shows an earlier tick than before, so it does not step back when the camera recedes. Updates
     * may have a budget. An update at an earlier time than the last one forgets the ticks shown before. */
    CLQ_CLOCK_LIVE = 1
} clq_clock;

typedef struct clq_crowd_def {
    uint32_t struct_bytes; /* set by clq_crowd_def_init */
    clq_cache_mode cache;
    /* Memory of palettes and vertices together; 0: 1 GiB. Individuals beyond the budget are posed and skinned in every
     * update, in memory outside it: clq_crowd_stats.arena_bytes. */
    uint64_t cache_budget_bytes;
    /* The update period (S1 4): linear in the squared eyeDistance, rounded down to one of 1/50 ... 1/4 s. */
    float period_near_s;   /* [0, 1] up to distance_near_m; 0: every frame. Default 0.02 */
    float period_far_s;    /* [>= period_near_s] from distance_far_m on. Default 0.25 */
    float distance_near_m; /* [>= 0] default 5 */
    float distance_far_m;  /* [> distance_near_m] default 50 */
    float metres_per_unit; /* (> 0) metres in a world unit. Default 1 */
    uint64_t seed;         /* of all random choices in this crowd */
    clq_cull_mode cull;
    clq_rigid_mode rigid_mode;
    /* The level of detail follows the effective distance (S0 5): eyeDistance * (1 - priority) * the view's scale
     * (clq_view_set_height) * lod_scale / the scale of the actor in the world. */
    float lod_scale; /* [>= 0] 0: the finest level everywhere. Default 1 */
    /* [0, 1) the share of a switch distance that an actor must pass on its way back before its level changes again.
     * Default 0: a level is a function of the distance. */
    float lod_hysteresis;
    clq_vertex_format vertex_format;
    clq_clock clock;
    /* Poses that an update renews at most; 0: all that are due. Needs CLQ_CLOCK_LIVE and a cache. Actors that must wait
     * show their last pose. Actors that would otherwise keep a pose for nearly two periods come first, then near ones.
     * Actors without a pose, with a pose of another clip, or whose pose no cache has room for are posed first and, if
     * need be, beyond the budget: see over_budget and overdue in clq_crowd_stats. */
    uint32_t update_budget;
    /* [>= 0] the same limit in milliseconds of posing and skinning, estimated from the cost of earlier updates; 0: no
     * limit. The lower of both limits holds. The picture then depends on the speed of the machine. Needs now_s. */
    float update_budget_ms;
    /* A clock in seconds that never goes back; clq_crowd_update calls it on its thread. If it throws, the update goes
     * on without measuring, and claque logs a warning. */
    double (*now_s)(void *user);
    void *now_user;
    clq_key_poses key_poses; /* shared key-poses (S3). Default: none */
    /* [>= 0] An actor that moves (claque/speed.h) is renewed so often that it moves by at most so many pixels between
     * two poses, in the view's picture and in one of 768 lines over 60 degrees. 0: no limit. Default 1 */
    float motion_tolerance_px;
} clq_crowd_def;

static inline clq_crowd_def clq_crowd_def_init(void)
{
    clq_crowd_def def;
    memset(&def, 0, sizeof def);
    def.struct_bytes = (uint32_t)sizeof def;
    def.period_near_s = 0.02f;
    def.period_far_s = 0.25f;
    def.distance_near_m = 5.0f;
    def.distance_far_m = 50.0f;
    def.metres_per_unit = 1.0f;
    def.lod_scale = 1.0f;
    def.key_poses = clq_key_poses_init();
    def.motion_tolerance_px = 1.0f;
    return def;
}

/* Creates an empty crowd.
 *   def   copied; NULL means clq_crowd_def_init()
 *   out   owned by the host until clq_crowd_destroy
 * Fails: STRUCT_SIZE, ARGUMENT, OUT_OF_MEMORY. Threads: any. GL: none. */
CLQ_API clq_status clq_crowd_create(clq_context *context, const clq_crowd_def *def, clq_crowd **out);

/* Destroys a crowd with its actors and views; NULL is ignored. Renderers live on.
 * Fails: BUSY; the crowd then stays. Threads: the crowd's writer. GL: none. */
CLQ_API clq_status clq_crowd_destroy(clq_crowd *crowd);

/* A rigid transform with a scale. As an actor's, it places its Reference Point (S0 3). */
typedef struct clq_transform {
    double position[3];        /* in world units; of a group's member in the units of the group's space */
    float orientation_xyzw[4]; /* of length 1 within 0.001; all zero means no rotation */
    float scale;               /* world units per model unit, finite; negative mirrors; 0 means 1 */
} clq_transform;

static inline clq_transform clq_transform_init(void)
{
    clq_transform transform;
    memset(&transform, 0, sizeof transform);
    transform.orientation_xyzw[3] = 1.0f;
    transform.scale = 1.0f;
    return transform;
}

/* A clip and its clock: at time t the clip stands at phase_s + speed * (t - start_s), looping. */
typedef struct clq_play {
    uint32_t clip;  /* of the actor's template; CLQ_NONE (default): the rest pose */
    double start_s; /* on the clock of clq_crowd_update */
    float speed;    /* finite; negative plays backwards, 0 stands still. Default 1 */
    float phase_s;  /* finite */
} clq_play;

static inline clq_play clq_play_init(void)
{
    clq_play play;
    memset(&play, 0, sizeof play);
    play.clip = CLQ_NONE;
    play.speed = 1.0f;
    return play;
}

/* A texture set that is sampled from the seeds of crowd and actor. */
#define CLQ_RANDOM 0xffffffffu

typedef struct clq_actor_def {
    uint32_t struct_bytes; /* set by clq_actor_def_init */
    clq_template *tmpl;    /* the crowd holds it until the crowd is destroyed */
    clq_transform transform;
    clq_play play;
    uint64_t seed;        /* of this individual's random choices, with the crowd's seed; equal seeds give twins */
    uint32_t texture_set; /* as in clq_actor_set_texture_set. Default 0 */
} clq_actor_def;

static inline clq_actor_def clq_actor_def_init(void)
{
    clq_actor_def def;
    memset(&def, 0, sizeof def);
    def.struct_bytes = (uint32_t)sizeof def;
    def.transform = clq_transform_init();
    def.play = clq_play_init();
    return def;
}

/* Creates an actor. It shows its template's zone colours until it gets its own. It costs only its own state (S0 7.1).
 *   def   copied; the template must be of the crowd's context
 *   out   the actor, which ends with clq_actor_destroy or with the crowd
 * Fails: STRUCT_SIZE, ARGUMENT, LIMIT, OUT_OF_MEMORY, BUSY. Threads: the crowd's writer. GL: none. */
CLQ_API clq_status clq_actor_create(clq_crowd *crowd, const clq_actor_def *def, clq_actor *out);

/* Destroys an actor and its attachments. Fails: STALE_ID, BUSY. Threads: the crowd's writer. GL: none. */
CLQ_API clq_status clq_actor_destroy(clq_crowd *crowd, clq_actor actor);

/* Plays a clip, at once and in place of everything that the actor plays; clq_actor_fade_to fades.
 * Fails: STALE_ID, ARGUMENT (a clip that the template lacks, a number that is not finite), BUSY.
 * Threads: the crowd's writer. GL: none. */
CLQ_API clq_status clq_actor_play(clq_crowd *crowd, clq_actor actor, const clq_play *play);

/* Sets the transforms of actors: of all or, when it fails, of none.
 *   actors, transforms   [count]; the transform of a group's member is in the group's space
 * Fails: STALE_ID (names the first), ARGUMENT, OUT_OF_MEMORY, BUSY. Threads: the crowd's writer. GL: none. */
CLQ_API clq_status clq_crowd_set_transforms(clq_crowd *crowd, const clq_actor *actors, const clq_transform *transforms,
                                            uint32_t count);

/* Sets the colours of an individual, rounded to 8 bits (S1 3).
 *   rgb   [3 * zone_count], each [0, 1], as glColor takes them, by zone of its template
 * Fails: STALE_ID, ARGUMENT, OUT_OF_MEMORY, BUSY. Threads: the crowd's writer. GL: none. */
CLQ_API clq_status clq_actor_set_colours(clq_crowd *crowd, clq_actor actor, const float *rgb, uint32_t zone_count);

/* Samples the colours of an individual from HSB ranges, by the seeds of crowd and actor (S2 5). The same call gives the
 * same colours.
 *   ranges   [zone_count], or NULL with zone_count 0: the template's own ranges
 * Fails: STALE_ID, ARGUMENT, OUT_OF_MEMORY, BUSY. Threads: the crowd's writer. GL: none. */
CLQ_API clq_status clq_actor_randomise_colours(clq_crowd *crowd, clq_actor actor, const clq_hsb_range *ranges,
                                               uint32_t zone_count);

/* Sets the texture set of an individual (S1 1).
 *   set   [0, clq_template_info.texture_set_count), or CLQ_RANDOM
 * Fails: STALE_ID, ARGUMENT, BUSY. Threads: the crowd's writer. GL: none. */
CLQ_API clq_status clq_actor_set_texture_set(clq_crowd *crowd, clq_actor actor, uint32_t set);

/* Creates an actor like another one: with its template, clips, fades and layers, colours, texture set, mechanisms with
 * their commands, root path, track, group, priority, speed, hooks and ground, but without its attachments (S0 7.1).
 * Nothing of the template is copied.
 *   transform   in the other's group, if it has one; NULL: the other's own
 *   seed        of its later random choices; it keeps the other's colours until they are set or sampled
 * Fails: STALE_ID, ARGUMENT, LIMIT, OUT_OF_MEMORY, BUSY. Threads: the crowd's writer. GL: none. */
CLQ_API clq_status clq_actor_clone(clq_crowd *crowd, clq_actor actor, const clq_transform *transform, uint64_t seed,
                                   clq_actor *out);

/* Sets the priority of an actor (S0 5). It raises the detail of its levels and of its behaviour; it does not change the
 * update rate.
 *   priority   [0, 1]; 0 (default): the detail follows the distance; 1: always the finest
 * Fails: STALE_ID, ARGUMENT, BUSY. Threads: the crowd's writer. GL: none. */
CLQ_API clq_status clq_actor_set_priority(clq_crowd *crowd, clq_actor actor, float priority);

/* An object of the host's scene that an actor carries. */
typedef struct clq_attachment_def {
    uint32_t struct_bytes; /* set by clq_attachment_def_init */
    uint32_t node;         /* of the actor's template */
    float centre[3];       /* of the object's bounding sphere, in the node's frame, in model units */
    float radius;          /* [>= 0] in model units */
} clq_attachment_def;

CLQ_DEFINE_ZERO_INIT(clq_attachment_def)

/* Attaches an object to a node of an actor (S0 4.3). The actor's bounding spheres grow to hold the object in every
 * pose, and shrink when it is detached. claque does not draw the object; clq_actor_get_node says where it is. The
 * attachment ends with the actor.
 *   out   may be NULL
 * Fails: STRUCT_SIZE, STALE_ID, ARGUMENT, OUT_OF_MEMORY, BUSY. Threads: the crowd's writer. GL: none. */
CLQ_API clq_status clq_actor_attach(clq_crowd *crowd, clq_actor actor, const clq_attachment_def *def,
                                    clq_attachment *out);

/* Ends an attachment. Fails: STALE_ID, BUSY. Threads: the crowd's writer. GL: none. */
CLQ_API clq_status clq_actor_detach(clq_crowd *crowd, clq_attachment attachment);

/* Gets the matrix of a node in the world, from the pose at the finest level. Host mechanisms do not run for it.
 *   time_s       the time of the pose, which is evaluated anew. NaN: the pose of the last update that saw the actor
 *                (its tick), carried rigidly by the Reference Point and the Skeleton Root of that update; if the last
 *                update did not see the actor, the pose of that update's time
 *   out_matrix   [16] column-major, from the node's frame to the world
 * Fails: STALE_ID, ARGUMENT, OUT_OF_MEMORY, BUSY. Threads: the crowd's writer. GL: none. */
CLQ_API clq_status clq_actor_get_node(clq_crowd *crowd, clq_actor actor, uint32_t node, double time_s,
                                      double out_matrix[16]);

/* Sets the callbacks around the drawing of an actor.
 *   hooks   copied; NULL: none
 * Fails: STALE_ID, OUT_OF_MEMORY, BUSY. Threads: the crowd's writer. GL: none. */
CLQ_API clq_status clq_actor_set_hooks(clq_crowd *crowd, clq_actor actor, const clq_actor_hooks *hooks);

typedef struct clq_actor_info {
    uint32_t struct_bytes; /* set by clq_actor_info_init */
    const clq_template *tmpl;
    clq_transform transform; /* in the space of its group, if it has one */
    clq_group group;         /* {0, 0}: none */
    clq_play play;
    uint64_t seed;
    bool visible; /* a view of the last update saw it */
    /* The next five are of the last update that saw it. */
    float period_s;       /* its update period */
    double tick_s;        /* the time of the pose that it showed */
    float eye_distance_m; /* from its Skeleton Root to the nearest eye */
    uint32_t level;       /* its level of detail */
    clq_transform root;   /* its Skeleton Root in the world; before the first such update its Reference Point */
    float priority;
    /* Its bounding spheres now (S0 4.1), in model units, with its root path and attachments. */
    float refpoint_radius, sklsroot_radius;
    uint32_t texture_set;
} clq_actor_info;

CLQ_DEFINE_ZERO_INIT(clq_actor_info)

/* Gets the state of an actor.
 *   out   made by clq_actor_info_init
 * Fails: STRUCT_SIZE, STALE_ID, ARGUMENT, BUSY. Threads: any. GL: none. */
CLQ_API clq_status clq_actor_get_info(const clq_crowd *crowd, clq_actor actor, clq_actor_info *out);

/* Returns the number of actors; 0 for NULL and where clq_actor_get_info would be BUSY. Threads: any. GL: none. */
CLQ_API uint32_t clq_crowd_get_actor_count(const clq_crowd *crowd);

/* Returns a hash of everything that the host has set in the crowd; 0 for NULL and where clq_actor_get_info would be
 * BUSY. Crowds made by the same calls have equal hashes. Threads: any. GL: none. */
CLQ_API uint64_t clq_crowd_get_hash(const clq_crowd *crowd);

/* Computes one frame: places Skeleton Roots, culls, finds the actors whose pose is due, animates and skins them, and
 * makes the draw list of each view (S0 4.2, S1 4). The context's tasks share the work.
 *   time_s   the host's clock; it may jump and go back. With CLQ_CLOCK_REFERENCE the picture is a function of time_s
 *            and the distances
 *   views    [view_count] of this crowd, each once; the draw lists of its other views become empty
 * Fails: ARGUMENT, LIMIT, BUSY, OUT_OF_MEMORY, CALLBACK (the ground or a host mechanism threw an exception; what
 * callbacks did before it stays done). The crowd, its statistics and all draw lists then stay as they were. If the
 * allocator refuses memory for the palette or the vertices of single individuals, the update does not fail:
 * clq_crowd_stats counts them in left_out, and draws leave them out and return OUT_OF_MEMORY.
 * Threads: the crowd's writer. GL: none. */
CLQ_API clq_status clq_crowd_update(clq_crowd *crowd, double time_s, clq_view *const *views, uint32_t view_count);

#ifdef __cplusplus
}
#endif

#endif
