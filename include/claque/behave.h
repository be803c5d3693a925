/* Control mechanisms (S0 5.3, 7.1): what moves an actor beside its clip: flight, gaze, expression, blinking, phrases, idle
 * clips, and the host's own. And the movement of the Skeleton Root round the Reference Point (S0 3).
 *
 * A mechanism is described once in a crowd and used by any number of its actors. It runs only for who passed the second cull
 * phase and is due, at a level of its own that falls with the distance (behavioural LOD). What it writes is a function of
 * time, of the actor's seed and of what the host has commanded, so that whoever comes back into view is where its clock
 * says. Several on one actor run by priority, the highest last: it has the last word on what it writes.
 *
 * Mechanisms and paths live as long as their crowd. Everything here is for the crowd's writer; GL: none. */
#ifndef CLAQUE_BEHAVE_H
#define CLAQUE_BEHAVE_H

#include <claque/crowd.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Of one crowd; zero is none. */
typedef struct clq_mechanism {
    uint32_t index1;
} clq_mechanism;

typedef struct clq_root_path {
    uint32_t index1;
} clq_root_path;

typedef enum clq_mechanism_kind {
    CLQ_MECHANISM_GAZE = 0,       /* eyes, neck and spine share the turn towards a point */
    CLQ_MECHANISM_EXPRESSION = 1, /* one of several shapes of a face at a time */
    CLQ_MECHANISM_BLINK = 2,
    CLQ_MECHANISM_PHRASE = 3, /* mouth shapes in time */
    CLQ_MECHANISM_IDLE = 4,   /* clips by lot, in place of what the actor plays */
    CLQ_MECHANISM_HOST = 5    /* the host's own */
} clq_mechanism_kind;

/* A degree of freedom of the template and where it goes. */
typedef struct clq_dof_value {
    uint32_t dof;
    float value; /* within its range */
} clq_dof_value;

/* Values that belong together: a smile, a mouth that says O. Each degree of freedom once; those that a shape does not name
 * stay as mechanisms of less priority leave them, and are gone over to and from smoothly. */
typedef struct clq_dof_pose {
    uint32_t count;
    const clq_dof_value *values; /* [count] */
} clq_dof_pose;

/* Degrees of freedom are rotations; CLQ_NONE: left out. The spine takes spine_share of the turn, the neck neck_share of the
 * rest, the eyes what is left, each within its range. Yaw is positive to the actor's left, pitch upwards. A point in its
 * back is looked at over the shoulder on whose side it looked before, the left one from straight on; who is carried along
 * a path lets go of points in its back instead. Each level does without the finest part that is left, eyes, then neck; a
 * level more than there are parts without the pitch. What a part would take the others do not take in its stead. */
typedef struct clq_gaze_def {
    uint32_t eye_yaw[2], eye_pitch[2], neck_yaw, neck_pitch, spine_yaw, spine_pitch;
    float neck_share, spine_share; /* [0, 1] */
    float eyes[3];                 /* between the eyes at rest, in the actor's own space, which looks along +z */
    float turn_s;                  /* [>= 0] that a turn to another point takes */
    float wander_s;                /* [>= 0] without a point: looks elsewhere about this often; 0: straight on */
    float wander_yaw_rad, wander_pitch_rad; /* [0, pi] how far it wanders */
} clq_gaze_def;

/* From level 1 on shapes change at once, half-way through the blend; so do lids and mouths. */
typedef struct clq_expression_def {
    uint32_t pose_count;
    const clq_dof_pose *poses; /* one without values: the face at rest */
    float hold_s;              /* [> 0] about how long each stays: 0.5 to 1.5 times this, by lot; then another one */
    float blend_s;             /* [>= 0] from one to the next; at most hold_s / 2 */
} clq_expression_def;

typedef struct clq_blink_def {
    clq_dof_pose closed; /* lids shut */
    float period_s;      /* [> close_s] once in each such time, when is drawn by lot */
    float close_s;       /* [> 0] from open to open again */
} clq_blink_def;

typedef struct clq_phrase_key {
    float time_s;  /* ascending from 0 */
    uint32_t pose; /* CLQ_NONE: the mouth at rest */
} clq_phrase_key;

typedef struct clq_phrase_def {
    uint32_t pose_count;
    const clq_dof_pose *poses;
    uint32_t key_count;
    const clq_phrase_key *keys;
    float length_s; /* [> 0, >= the last key's time] then the mouth goes to rest */
    float pause_s;  /* 0.5 to 1.5 times this passes before it is said again; negative: said on command only */
    float blend_s;  /* [>= 0] from one shape to the next, and to rest; less where keys are closer together */
} clq_phrase_def;

/* Actors change their clips at different times, by lot. Clips that begin and end in one pose, and whose lengths divide
 * slot_s, follow each other without a seam; others with fade_s. */
typedef struct clq_idle_def {
    uint32_t clip_count;
    const uint32_t *clips;
    float slot_s;         /* [> 0] how long each is played, from its beginning */
    const float *weights; /* [clip_count], each >= 0, not all 0: what share of the lots each has; NULL: equal */
    float fade_s;         /* [0, slot_s] that the clip before takes to go, played on; actors that use it are culled by
                             spheres that hold every blend (claque/play.h) */
    float speed_spread;   /* [0, 1) speeds are 1 - this to 1 + this, by lot */
    float phase_spread;   /* [0, 1] of a clip's length: where in it it begins, by lot */
} clq_idle_def;

/* What a host's mechanism is told. */
typedef struct clq_behaviour_call {
    clq_actor actor;
    uint32_t level;     /* of this mechanism, 0 is the finest */
    uint64_t seed;      /* of the actor */
    double time_s;      /* of the pose: the actor's tick, at or before the time of the update */
    float eye_distance; /* world units; of mechanisms that keep a memory from the Reference Point to the nearest eye */
    int32_t visible;    /* 1: it passed the second cull phase; of mechanisms that keep a memory always 0 */
} clq_behaviour_call;

typedef struct clq_dof_writer clq_dof_writer;

/* Writes a degree of freedom during a call: weight of `value`, the rest of what is there already. Held to its range;
 * a number that is not finite, or of no degree of freedom, is ignored, as is one whose node is deactivated. */
CLQ_API void clq_dof_write(clq_dof_writer *writer, uint32_t dof, float value, float weight);

typedef struct clq_host_mechanism_def {
    /* Called on the thread of clq_crowd_update, in the order of actors. May call nothing of claque but clq_dof_write. */
    void (*run)(void *user, const clq_behaviour_call *call, clq_dof_writer *writer);
    void *user;
    /* 0: what it writes is a function of what it is told. 1: it keeps a memory; it then runs in every update for every
     * actor that uses it, seen or not, with the update's time, and such an actor is due in every frame. It is never off:
     * off_m is 0, and what it writes to nodes that are lost is ignored. */
    int32_t has_memory;
} clq_host_mechanism_def;

typedef struct clq_mechanism_def {
    uint32_t struct_bytes; /* set by clq_mechanism_def_init */
    clq_mechanism_kind kind;
    const clq_template *tmpl; /* whose degrees of freedom and clips it names; used by at least one actor already */
    /* S0 5.3, [metres] at the actor's effective distance: level k + 1 begins at level_m[k], ascending; 0: no further one.
     * From off_m on the mechanism does not run; 0: never off by itself. It is off where the skeleton has lost every node
     * that it writes, and writes none of those that are lost. */
    float level_m[3]; /* those after a 0 are 0 as well */
    float off_m;
    clq_gaze_def gaze; /* that of `kind` is read */
    clq_expression_def expression;
    clq_blink_def blink;
    clq_phrase_def phrase;
    clq_idle_def idle;
    clq_host_mechanism_def host;
} clq_mechanism_def;

static inline clq_mechanism_def clq_mechanism_def_init(void)
{
    clq_mechanism_def def;
    unsigned char *p = (unsigned char *)&def;
    size_t i;
    for (i = 0; i < sizeof def; ++i) p[i] = 0;
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

/* Describes a mechanism; copied, arrays included.
 * Fails: STRUCT_SIZE, ARGUMENT (the first broken rule, named), OUT_OF_MEMORY. */
CLQ_API clq_status clq_crowd_add_mechanism(clq_crowd *crowd, const clq_mechanism_def *def, clq_mechanism *out);

/* How one actor uses a mechanism: its clock stands at time - start_s + phase_s. */
typedef struct clq_mechanism_attachment {
    clq_mechanism mechanism;
    float priority; /* finite; equal ones run in the order of their use */
    float phase_s;
    double start_s;
} clq_mechanism_attachment;

/* Lets an actor use a mechanism of its template, at most 16; one that it uses already gets the new values.
 * Fails: STALE_ID, ARGUMENT, LIMIT, OUT_OF_MEMORY. */
CLQ_API clq_status clq_actor_attach_mechanism(clq_crowd *crowd, clq_actor actor,
                                              const clq_mechanism_attachment *attachment);

/* Ends a use; one that there is not is ignored. Fails: STALE_ID, ARGUMENT. */
CLQ_API clq_status clq_actor_detach_mechanism(clq_crowd *crowd, clq_actor actor, clq_mechanism mechanism);

/* Commands of one actor's mechanisms, from at_s on (on the update's clock; times before that show what was commanded
 * before). The last two are remembered; one for an earlier time replaces those that begin later.
 * Fail: STALE_ID, ARGUMENT (no such use, or of another kind), OUT_OF_MEMORY.
 * gaze: a point in the world (of its group, for a member), kept relative to the Reference Point: it goes where the actor
 * is placed, so ask again when that or the point has moved. A point within 5 degrees of the last one, as the actor sees it,
 * is the same one, and the turn to it goes on: so one that moves can be given anew in every frame. NULL: it wanders, or
 * looks straight on. */
CLQ_API clq_status clq_actor_gaze(clq_crowd *crowd, clq_actor actor, clq_mechanism gaze, const double *point,
                                  double at_s);
/* A shape of an expression, or CLQ_NONE: by lot. */
CLQ_API clq_status clq_actor_express(clq_crowd *crowd, clq_actor actor, clq_mechanism expression, uint32_t pose,
                                     double at_s);
/* Says a phrase, once, from its beginning, over what it says by itself. */
CLQ_API clq_status clq_actor_say(clq_crowd *crowd, clq_actor actor, clq_mechanism phrase, double at_s);

/* A closed way of the Skeleton Root round the Reference Point, in the actor's own space. It is what makes the Refpoint
 * Bsphere larger than the Sklsroot Bsphere (S0 4.1). */
typedef struct clq_root_path_def {
    uint32_t struct_bytes;  /* set by clq_root_path_def_init */
    uint32_t count;         /* [>= 2] */
    const float *positions; /* [3 * count] */
    /* A table: [4 * count] quaternions x y z w, unit within 0.001, and times_s [count], ascending from 0. At duration_s it
     * is back at the first; a key of that time must be like the first. NULL, both: a flight, which meets the positions at
     * equal times on a smooth closed curve, looks along it (+z ahead, +y up) and banks into its turns. */
    const float *rotations_xyzw;
    const float *times_s;
    float duration_s;   /* [> 0] of a round */
    float bank;         /* flight: [radians] for each radian a second that it turns; 0: never */
    float max_bank_rad; /* [0, pi] */
} clq_root_path_def;

static inline clq_root_path_def clq_root_path_def_init(void)
{
    clq_root_path_def def;
    unsigned char *p = (unsigned char *)&def;
    size_t i;
    for (i = 0; i < sizeof def; ++i) p[i] = 0;
    def.struct_bytes = (uint32_t)sizeof def;
    def.duration_s = 1.0f;
    def.bank = 0.5f;
    def.max_bank_rad = 0.9f;
    return def;
}

/* Fails: STRUCT_SIZE, ARGUMENT, OUT_OF_MEMORY. */
CLQ_API clq_status clq_crowd_add_root_path(clq_crowd *crowd, const clq_root_path_def *def, clq_root_path *out);

/* How one actor goes along a path: it stands at phase_s + speed * (t - start_s), going round. */
typedef struct clq_root_path_play {
    clq_root_path path; /* {0}: the Skeleton Root stays at the Reference Point */
    float speed;        /* finite; negative goes backwards */
    float phase_s;
    double start_s;
} clq_root_path_play;

/* Fails: STALE_ID, ARGUMENT, OUT_OF_MEMORY. */
CLQ_API clq_status clq_actor_play_root_path(clq_crowd *crowd, clq_actor actor, const clq_root_path_play *play);

/* The height of the ground, in world units, under (or over) a point in the world. `up_axis` 1: y. Called on the thread of
 * clq_crowd_update for actors that follow the ground and passed the first cull phase; a function of the point alone. May
 * call nothing of claque. NULL: nobody follows. Fails: ARGUMENT. */
CLQ_API clq_status clq_crowd_set_ground(clq_crowd *crowd, double (*height)(void *user, const double point[3]),
                                        void *user);

/* Lets an actor's Skeleton Root stand on the ground instead of at its Reference Point's height, as far as max_up above or
 * max_down below it (world units, >= 0; both 0: it does not follow). The Refpoint Bsphere grows by the larger of them.
 * Members of groups do not follow: their floor is the group's. Fails: STALE_ID, ARGUMENT. */
CLQ_API clq_status clq_actor_follow_ground(clq_crowd *crowd, clq_actor actor, float max_up, float max_down);

#ifdef __cplusplus
}
#endif

#endif
