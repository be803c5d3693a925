/* Control mechanisms (S0 5.3, 7.1): what moves an actor besides its clip, such as gaze, expression, blinking, phrases,
 * idle clips and the host's own mechanisms. Root paths (S0 3): they move the Skeleton Root round the Reference Point.
 *
 * A mechanism is described once in a crowd and attached to any number of its actors. It runs for actors that passed the
 * second cull phase and whose pose is due, at a level of its own that falls with the effective distance (behavioural
 * level of detail). What it writes is a function of time, of the actor's seed and of the host's commands, so an actor
 * that comes back into view is where its clock says. The mechanisms of an actor run in ascending order of priority;
 * later ones write over earlier ones.
 *
 * Mechanisms and root paths live as long as their crowd. Threads: the crowd's writer. GL: none. All calls except
 * clq_dof_write may fail with BUSY. */
#ifndef CLAQUE_BEHAVE_H
#define CLAQUE_BEHAVE_H

#include <claque/crowd.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Mechanisms and root paths belong to one crowd. {0} is none. */
typedef struct clq_mechanism {
    uint32_t index1;
} clq_mechanism;

typedef struct clq_root_path {
    uint32_t index1;
} clq_root_path;

typedef enum clq_mechanism_kind {
    CLQ_MECHANISM_GAZE = 0,       /* turns spine, neck and eyes to a point */
    CLQ_MECHANISM_EXPRESSION = 1, /* shows one of several poses of a face at a time */
    CLQ_MECHANISM_BLINK = 2,      /* shuts the lids */
    CLQ_MECHANISM_PHRASE = 3,     /* moves the mouth through timed poses */
    CLQ_MECHANISM_IDLE = 4,       /* plays randomly chosen clips in place of the actor's own */
    CLQ_MECHANISM_HOST = 5        /* calls the host */
} clq_mechanism_kind;

/* A value of a degree of freedom. */
typedef struct clq_dof_value {
    uint32_t dof;
    float value; /* within its range */
} clq_dof_value;

/* Values that belong together, such as a smile or a mouth that says O. Each degree of freedom occurs once. Degrees of
 * freedom that a pose does not name keep the values of mechanisms with lower priority; changes between poses are
 * smooth. */
typedef struct clq_dof_pose {
    uint32_t count;
    const clq_dof_value *values; /* [count] */
} clq_dof_pose;

/* Looks at a point. The degrees of freedom are rotations; CLQ_NONE leaves one out, but not all of them. Yaw is positive
 * to the actor's left, pitch is positive upwards. The spine takes spine_share of the turn, the neck neck_share of the
 * rest, and the eyes the remainder, each within its range; what a part cannot turn is not given to the others. A target
 * behind is viewed over the last shoulder used, first the left; actors on a root path ignore a target behind them. Each
 * coarser level leaves out the finest part that remains: eyes first, then neck. A level beyond the number of parts
 * leaves out the pitch. */
typedef struct clq_gaze_def {
    uint32_t eye_yaw[2], eye_pitch[2], neck_yaw, neck_pitch, spine_yaw, spine_pitch;
    float neck_share, spine_share; /* [0, 1] default 0.6 and 0.2 */
    float eyes[3];                 /* the point between the eyes at rest, in model space; the actor looks along +z */
    float turn_s;                  /* [>= 0] the time of a turn to another point. Default 0.4 */
    float wander_s;                /* [>= 0] mean time between glances while there is no point; 0: straight ahead */
    float wander_yaw_rad, wander_pitch_rad; /* [0, pi] largest glance. Default 0.5 and 0.15 */
} clq_gaze_def;

/* Shows facial poses in random order. From level 1 on poses change at once, half-way through the blend; this also holds
 * for blinks and phrases. */
typedef struct clq_expression_def {
    uint32_t pose_count;       /* 1 or more */
    const clq_dof_pose *poses; /* [pose_count] one of them at least has values; one without is the face at rest */
    float hold_s;              /* (> 0) each pose stays for a random 0.5 to 1.5 times this. Default 4 */
    float blend_s;             /* [0, hold_s / 2] time from one pose to the next. Default 0.4 */
} clq_expression_def;

typedef struct clq_blink_def {
    clq_dof_pose closed; /* the lids shut; one value or more */
    float period_s;      /* (> close_s) one blink in each period, at a random time. Default 4 */
    float close_s;       /* (> 0) from open to open again. Default 0.15 */
} clq_blink_def;

typedef struct clq_phrase_key {
    float time_s;  /* ascending from 0 */
    uint32_t pose; /* CLQ_NONE: the mouth at rest */
} clq_phrase_key;

typedef struct clq_phrase_def {
    uint32_t pose_count;        /* 1 or more */
    const clq_dof_pose *poses;  /* [pose_count] one of them at least has values */
    uint32_t key_count;         /* 1 or more */
    const clq_phrase_key *keys; /* [key_count] */
    float length_s;             /* (> 0) at least the last key's time; then the mouth goes to rest */
    float pause_s; /* a random 0.5 to 1.5 times this passes before the next repetition; negative: only on command */
    float blend_s; /* [>= 0] between poses and to rest, shortened where keys are closer. Default 0.06 */
} clq_phrase_def;

/* Plays clips in random order; actors change at different times. Clips that begin and end in one pose and whose lengths
 * divide slot_s follow each other without a seam. Other clips need fade_s. */
typedef struct clq_idle_def {
    uint32_t clip_count;   /* 1 or more */
    const uint32_t *clips; /* [clip_count] */
    float slot_s;          /* (> 0) the time that each clip plays from its beginning. Default 6 */
    const float *weights;  /* [clip_count], each >= 0 and not all 0: relative frequencies; NULL: equal ones */
    /* [0, slot_s] the time over which the previous clip, which plays on, fades out. Bounding spheres of actors with a
     * fade hold every blend (claque/play.h). */
    float fade_s;
    float speed_spread; /* [0, 1) speeds are random within 1 - speed_spread and 1 + speed_spread */
    float phase_spread; /* [0, 1] phases are random within this fraction of the clip's length */
} clq_idle_def;

/* The arguments of a host mechanism. */
typedef struct clq_behaviour_call {
    clq_actor actor;
    uint32_t level; /* of this mechanism; 0 is the finest */
    uint64_t seed;  /* of the actor */
    double time_s;  /* of the pose: the actor's tick, at or before the time of the update */
    /* From the nearest eye to the Skeleton Root; for mechanisms that have memory, to the Reference Point. */
    float eye_distance_m;
    bool visible; /* the actor passed the second cull phase; false for mechanisms that have memory */
} clq_behaviour_call;

typedef struct clq_dof_writer clq_dof_writer;

/* Writes a degree of freedom, during a call of a host mechanism: its new value is weight * value + (1 - weight) * its
 * present value, clamped to its range. Ignored: numbers that are not finite, unknown degrees of freedom, and those of
 * deactivated nodes. */
CLQ_API void clq_dof_write(clq_dof_writer *writer, uint32_t dof, float value, float weight);

typedef struct clq_host_mechanism_def {
    /* clq_crowd_update calls it on its thread, in the order of actors. It must call nothing of claque but
     * clq_dof_write. */
    void (*run)(void *user, const clq_behaviour_call *call, clq_dof_writer *writer);
    void *user;
    /* False: what it writes is a function of its arguments. True: it keeps a memory. It then runs in every update for
     * every actor that uses it, visible or not, with the update's time, and these actors are due in every frame. off_m
     * must be 0, and writes to deactivated nodes are ignored. */
    bool has_memory;
} clq_host_mechanism_def;

typedef struct clq_mechanism_def {
    uint32_t struct_bytes; /* set by clq_mechanism_def_init */
    clq_mechanism_kind kind;
    /* The template of its degrees of freedom and clips. At least one actor of the crowd must have used it already. */
    const clq_template *tmpl;
    /* Behavioural level of detail (S0 5.3), at effective distances: level k + 1 begins at level_m[k], ascending; 0: no
     * further level, and all after it are 0 too. From off_m on the mechanism does not run; 0: it always runs. It also
     * stops where the skeleton has lost every node that it writes, and never writes lost nodes. */
    float level_m[3];
    float off_m;
    /* Only the member for `kind` is read. */
    clq_gaze_def gaze;
    clq_expression_def expression;
    clq_blink_def blink;
    clq_phrase_def phrase;
    clq_idle_def idle;
    clq_host_mechanism_def host;
} clq_mechanism_def;

static inline clq_mechanism_def clq_mechanism_def_init(void)
{
    clq_mechanism_def def;
    memset(&def, 0, sizeof def);
    def.struct_bytes = (uint32_t)sizeof def;
    def.gaze.eye_yaw[0] = def.gaze.eye_yaw[1] = def.gaze.eye_pitch[0] = def.gaze.eye_pitch[1] = CLQ_NONE;
    def.gaze.neck_yaw = def.gaze.neck_pitch = def.gaze.spine_yaw = def.gaze.spine_pitch = CLQ_NONE;
    def.gaze.neck_share = 0.6f;
    def.gaze.spine_share = 0.2f;
    def.gaze.turn_s = 0.4f;
    def.gaze.wander_yaw_rad = 0.5f;
    def.gaze.wander_pitch_rad = 0.15f;
    def.expression.hold_s = 4.0f;
    def.expression.blend_s = 0.4f;
    def.blink.period_s = 4.0f;
    def.blink.close_s = 0.15f;
    def.phrase.blend_s = 0.06f;
    def.idle.slot_s = 6.0f;
    return def;
}

/* Adds a mechanism to a crowd. Copied with its arrays.
 * Fails: STRUCT_SIZE, ARGUMENT (names the first broken rule), OUT_OF_MEMORY. */
CLQ_API clq_status clq_crowd_add_mechanism(clq_crowd *crowd, const clq_mechanism_def *def, clq_mechanism *out);

/* The use of a mechanism by one actor. The mechanism's clock stands at time - start_s + phase_s. */
typedef struct clq_mechanism_attachment {
    clq_mechanism mechanism;
    float priority; /* finite; mechanisms of equal priority run in the order in which they were attached */
    float phase_s;
    double start_s;
} clq_mechanism_attachment;

CLQ_DEFINE_PLAIN_INIT(clq_mechanism_attachment)

/* Attaches a mechanism to an actor of its template; an actor has at most 16. A mechanism that is attached already gets
 * the new values.
 * Fails: STALE_ID, ARGUMENT, LIMIT, OUT_OF_MEMORY. */
CLQ_API clq_status clq_actor_attach_mechanism(clq_crowd *crowd, clq_actor actor,
                                              const clq_mechanism_attachment *attachment);

/* Detaches a mechanism from an actor; one that is not attached is ignored. Fails: STALE_ID, ARGUMENT. */
CLQ_API clq_status clq_actor_detach_mechanism(clq_crowd *crowd, clq_actor actor, clq_mechanism mechanism);

/* Commands for the mechanisms of one actor. A command holds from at_s on, on the clock of clq_crowd_update; earlier
 * times show the earlier commands. The last two commands are remembered. A command replaces those that begin later.
 * Fail: STALE_ID, ARGUMENT (a mechanism that is not attached or of another kind), OUT_OF_MEMORY. */

/* Looks at a point in the world, or in the group's space for a member of a group. The point is kept relative to the
 * Reference Point and moves with it; so repeat the command after the actor or the point has moved. A point within 5
 * degrees of the last one, as the actor sees it, does not restart the turn; so a moving point may be given in every
 * frame.
 *   point   [3]; NULL: the gaze wanders or looks straight ahead */
CLQ_API clq_status clq_actor_gaze(clq_crowd *crowd, clq_actor actor, clq_mechanism gaze, const double *point,
                                  double at_s);

/* Shows a pose of an expression.
 *   pose   index; CLQ_NONE: random poses again */
CLQ_API clq_status clq_actor_express(clq_crowd *crowd, clq_actor actor, clq_mechanism expression, uint32_t pose,
                                     double at_s);

/* Says a phrase once from its beginning, in place of its repetitions. */
CLQ_API clq_status clq_actor_say(clq_crowd *crowd, clq_actor actor, clq_mechanism phrase, double at_s);

/* A root path: a closed curve of the Skeleton Root round the Reference Point, in model space. It makes the Refpoint
 * Bsphere larger than the Sklsroot Bsphere (S0 4.1). */
typedef struct clq_root_path_def {
    uint32_t struct_bytes;  /* set by clq_root_path_def_init */
    uint32_t count;         /* 2 or more */
    const float *positions; /* [3 * count] each coordinate within +-1e9 */
    /* Both given: a key-framing table. The rotations have length 1 within 0.001; the times ascend from 0. At duration_s
     * the path is back at the first key; a key at that time must equal the first one.
     * Both NULL: a flight. It passes the positions at equal intervals on a smooth closed curve, looks along it (+z
     * ahead, +y up) and banks into its turns. */
    const float *rotations_xyzw; /* [4 * count] or NULL */
    const float *times_s;        /* [count] or NULL */
    float duration_s;            /* (> 0) of one lap. Default 1 */
    float bank;                  /* flight: radians of bank for each radian per second of turn. Default 0.5 */
    float max_bank_rad;          /* [0, pi] default 0.9 */
} clq_root_path_def;

static inline clq_root_path_def clq_root_path_def_init(void)
{
    clq_root_path_def def;
    memset(&def, 0, sizeof def);
    def.struct_bytes = (uint32_t)sizeof def;
    def.duration_s = 1.0f;
    def.bank = 0.5f;
    def.max_bank_rad = 0.9f;
    return def;
}

/* Adds a root path to a crowd. Copied. Fails: STRUCT_SIZE, ARGUMENT, OUT_OF_MEMORY. */
CLQ_API clq_status clq_crowd_add_root_path(clq_crowd *crowd, const clq_root_path_def *def, clq_root_path *out);

/* The movement of one actor along a root path. It stands at phase_s + speed * (t - start_s) and loops. */
typedef struct clq_root_path_play {
    clq_root_path path; /* {0}: the Skeleton Root stays at the Reference Point */
    float speed;        /* finite; negative goes backwards. Default 1 */
    float phase_s;
    double start_s;
} clq_root_path_play;

static inline clq_root_path_play clq_root_path_play_init(void)
{
    clq_root_path_play play;
    memset(&play, 0, sizeof play);
    play.speed = 1.0f;
    return play;
}

/* Moves an actor along a root path. Fails: STALE_ID, ARGUMENT, OUT_OF_MEMORY. */
CLQ_API clq_status clq_actor_play_root_path(clq_crowd *crowd, clq_actor actor, const clq_root_path_play *play);

/* Sets the ground of a crowd's world. clq_crowd_update calls `height` on its thread, with the Skeleton Roots of actors
 * that follow the ground and passed the first cull phase.
 *   height   NULL: no actor follows the ground
 * Fails: ARGUMENT. */
CLQ_API clq_status clq_crowd_set_ground(clq_crowd *crowd, clq_height_function height, void *user);

/* Moves an actor's Skeleton Root along y to the ground.
 *   max_up, max_down   [>= 0] world units that it moves at most; both 0: the actor does not follow the ground
 * The Refpoint Bsphere grows by the larger one. Members of groups do not follow the ground.
 * Fails: STALE_ID, ARGUMENT, OUT_OF_MEMORY. */
CLQ_API clq_status clq_actor_follow_ground(clq_crowd *crowd, clq_actor actor, float max_up, float max_down);

#ifdef __cplusplus
}
#endif

#endif
