/* Playing more than one clip (S2 3.3): fades, gaits, layers over parts of the body; random choice of clips; events of
 * clips; root motion.
 *
 * What an actor shows is a function of time and of the commands it got: any time can be shown without the times before
 * it. An actor remembers its last three fades and four layers, with eight clips together at most. A command for which
 * there is no room beside what still runs at its time fails with LIMIT. Finished fades and layers are discarded oldest
 * first; earlier times then show the state that the oldest remembered fade started from. Poses are blended joint by
 * joint, rotations along the shorter arc. While an actor remembers fades or layers, its bounding spheres hold every
 * blend of its template's clips; clq_actor_play ends that.
 *
 * Threads: the crowd's writer, where a comment does not say otherwise. GL: none. */
#ifndef CLAQUE_PLAY_H
#define CLAQUE_PLAY_H

#include <claque/crowd.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Gaits and joint masks belong to one crowd and live as long as it. {0} is none. */
typedef struct clq_gait {
    uint32_t index1;
} clq_gait;

typedef struct clq_mask {
    uint32_t index1;
} clq_mask;

/* The course of a change over its time. */
typedef enum clq_curve {
    CLQ_CURVE_LINEAR = 0,
    CLQ_CURVE_SMOOTH = 1, /* starts and ends without a jerk */
    /* Fades between single clips only. The new clip is shown at once, plus the actor's difference from it in position
     * and velocity, which decays. The old clip stops, so a fade may leave it in the middle of a movement. */
    CLQ_CURVE_INERTIAL = 2
} clq_curve;

/* A gait: two clips of one cycle each, of any lengths, that play at one common phase and are blended by a share. */
typedef struct clq_gait_def {
    uint32_t struct_bytes;    /* set by clq_gait_def_init */
    const clq_template *tmpl; /* at least one actor of the crowd must have used it already */
    uint32_t clip_a, clip_b;  /* each with a length above 0 */
    /* Times that belong together, such as foot contacts, each on its clip's own axis: ascending, from the beginning of
     * the cycle to its end. 0: equal fractions of the cycles belong together, or sync_marker says. */
    uint32_t sync_count;
    const float *sync_a_s, *sync_b_s; /* [sync_count] */
    const char *sync_marker; /* with sync_count 0: the name of markers, equally many in both clips; NULL: none */
} clq_gait_def;

CLQ_DEFINE_ZERO_INIT(clq_gait_def)

/* Adds a gait to a crowd. Copied.
 * Fails: STRUCT_SIZE, ARGUMENT (names the first broken rule), OUT_OF_MEMORY, BUSY. */
CLQ_API clq_status clq_crowd_add_gait(clq_crowd *crowd, const clq_gait_def *def, clq_gait *out);

/* A joint mask: nodes by name, each with all nodes below it. */
typedef struct clq_mask_def {
    uint32_t struct_bytes;    /* set by clq_mask_def_init */
    const clq_template *tmpl; /* at least one actor of the crowd must have used it already */
    uint32_t node_count;      /* 1 or more */
    const char *const *nodes; /* [node_count] names of the template's nodes */
    uint32_t feather; /* [0, 1000] the weight grows to 1 over this many nodes down from a named one; 0: at once */
    bool inverted;    /* all other nodes instead */
} clq_mask_def;

CLQ_DEFINE_ZERO_INIT(clq_mask_def)

/* Adds a joint mask to a crowd. Copied.
 * Fails: STRUCT_SIZE, ARGUMENT (also a name that no node has), OUT_OF_MEMORY, BUSY. */
CLQ_API clq_status clq_crowd_add_mask(clq_crowd *crowd, const clq_mask_def *def, clq_mask *out);

/* A fade to a clip or to a gait. */
typedef struct clq_fade_def {
    uint32_t struct_bytes; /* set by clq_fade_def_init */
    clq_play play;         /* the clip; of a gait the start, speed and phase of its first clip (`clip` is not read) */
    clq_gait gait;         /* {0} (default): the clip */
    float share;           /* [0, 1] of the gait's second clip */
    double at_s;           /* when the fade begins, on the clock of clq_crowd_update */
    float length_s;        /* [>= 0] default 0.3 */
    clq_curve curve;       /* default SMOOTH */
} clq_fade_def;

static inline clq_fade_def clq_fade_def_init(void)
{
    clq_fade_def def;
    memset(&def, 0, sizeof def);
    def.struct_bytes = (uint32_t)sizeof def;
    def.play = clq_play_init();
    def.length_s = 0.3f;
    def.curve = CLQ_CURVE_SMOOTH;
    return def;
}

/* Fades an actor from what it plays to a clip or gait. The two clips of a gait are in step with each other, not with
 * what the actor played before. Times before at_s show the earlier commands. A fade that begins before others replaces
 * them. Fails: STRUCT_SIZE, STALE_ID, ARGUMENT, LIMIT, UNSUPPORTED (an inertial fade from or to a gait), OUT_OF_MEMORY,
 * BUSY. */
CLQ_API clq_status clq_actor_fade_to(clq_crowd *crowd, clq_actor actor, const clq_fade_def *def);

/* Changes the share of the gait that an actor plays, smoothly within length_s from its value at at_s. The pace follows
 * the share; the phase continues. Only the last change is remembered: times before at_s show the pace of at_s.
 *   share   [0, 1] of the gait's second clip
 * Fails: STALE_ID, ARGUMENT (also an actor that plays no gait), OUT_OF_MEMORY, BUSY. */
CLQ_API clq_status clq_actor_set_gait_share(clq_crowd *crowd, clq_actor actor, float share, double at_s,
                                            float length_s);

/* A layer of an actor. {0} is none. */
typedef struct clq_layer {
    uint32_t index1;
} clq_layer;

typedef enum clq_layer_kind {
    CLQ_LAYER_REPLACE = 0, /* the clip replaces what is below */
    CLQ_LAYER_ADD = 1      /* the clip's difference from a reference pose is added to what is below */
} clq_layer_kind;

typedef struct clq_layer_def {
    uint32_t struct_bytes; /* set by clq_layer_def_init */
    clq_layer_kind kind;
    clq_play play;               /* the layer is shown from play.start_s on */
    float weight;                /* REPLACE: [0, 1]; ADD: [-4, 4]. Default 1 */
    float loops;                 /* [>= 0] of the clip, fades included; 0: until clq_actor_end_layer */
    float fade_in_s, fade_out_s; /* [>= 0] */
    clq_curve curve;             /* LINEAR or SMOOTH. Default SMOOTH */
    clq_mask mask;               /* {0}: the whole body */
    /* The reference pose of ADD. false (default): the start of the layer's own clip. true: the pose of reference_clip
     * (CLQ_NONE: the rest pose) at reference_time_s on that clip's own axis. */
    bool has_reference;
    uint32_t reference_clip;
    float reference_time_s;
} clq_layer_def;

static inline clq_layer_def clq_layer_def_init(void)
{
    clq_layer_def def;
    memset(&def, 0, sizeof def);
    def.struct_bytes = (uint32_t)sizeof def;
    def.play = clq_play_init();
    def.weight = 1.0f;
    def.curve = CLQ_CURVE_SMOOTH;
    return def;
}

/* Adds a layer on top of what an actor plays, above its other layers. A finished layer is not shown.
 *   out   may be NULL
 * Fails: STRUCT_SIZE, STALE_ID, ARGUMENT, LIMIT, OUT_OF_MEMORY, BUSY. */
CLQ_API clq_status clq_actor_add_layer(clq_crowd *crowd, clq_actor actor, const clq_layer_def *def, clq_layer *out);

/* Fades a layer out within fade_out_s from at_s on. A layer that would end earlier is left alone.
 * Fails: STALE_ID (also of a layer that has been discarded), ARGUMENT, OUT_OF_MEMORY, BUSY. */
CLQ_API clq_status clq_actor_end_layer(clq_crowd *crowd, clq_actor actor, clq_layer layer, double at_s,
                                       float fade_out_s);

/* A random choice of a clip, a speed and a phase (S0 7.1), so that a crowd does not move as one. */
typedef struct clq_random_play_def {
    uint32_t struct_bytes; /* set by clq_random_play_def_init */
    uint32_t clip_count;   /* 1 or more */
    const uint32_t *clips; /* [clip_count] */
    const float *weights;  /* [clip_count], each >= 0 and not all 0: relative frequencies; NULL: equal ones */
    float speed_spread;    /* [0, 1) speeds are within 1 - speed_spread and 1 + speed_spread */
    float phase_spread;    /* [0, 1] phases are within this fraction of the clip's length */
    uint32_t sample_index; /* equal indices give an actor equal samples */
    double start_s;        /* of the play */
} clq_random_play_def;

CLQ_DEFINE_ZERO_INIT(clq_random_play_def)

/* Samples a play from the seeds of crowd and actor, for clq_actor_play or a fade. Changes nothing.
 * Fails: STRUCT_SIZE, STALE_ID, ARGUMENT, BUSY. Threads: any. */
CLQ_API clq_status clq_actor_sample_play(const clq_crowd *crowd, clq_actor actor, const clq_random_play_def *def,
                                         clq_play *out);

/* A clip that an actor shows. */
typedef struct clq_active_clip {
    uint32_t clip;      /* CLQ_NONE: the rest pose */
    double clip_time_s; /* on the clip's own axis */
    float weight;
    clq_layer_kind kind;
} clq_active_clip;

#define CLQ_ACTIVE_CLIP_MAX 8

/* Gets the clips that an actor shows at a time, in the order of blending, at the finest level.
 *   out   [CLQ_ACTIVE_CLIP_MAX], of which *out_count are written
 * Fails: STALE_ID, ARGUMENT, BUSY. Threads: any. */
CLQ_API clq_status clq_actor_get_active_clips(const clq_crowd *crowd, clq_actor actor, double time_s,
                                              clq_active_clip out[CLQ_ACTIVE_CLIP_MAX], uint32_t *out_count);

typedef enum clq_event_kind {
    CLQ_EVENT_MARKER = 0,    /* a clip passes one of its markers */
    CLQ_EVENT_CLIP_END = 1,  /* a loop of a clip ends and the next one begins */
    CLQ_EVENT_FADE_END = 2,  /* a fade ends */
    CLQ_EVENT_LAYER_END = 3, /* a layer ends */
    CLQ_EVENT_STEP = 4,      /* an actor that walks on a track (claque/track.h) puts a foot down */
    CLQ_EVENT_STAND = 5      /* an actor on a track begins to stand */
} clq_event_kind;

/* An event in an actor's clips. Events happen whether the actor is visible or not. */
typedef struct clq_event {
    double time_s; /* on the clock of clq_crowd_update */
    clq_actor actor;
    clq_event_kind kind;
    uint32_t clip;   /* the clip that plays; of a gait its first clip; of a fade its target; of a step the walk */
    uint32_t marker; /* for clq_template_get_marker; of a step 0 left, 1 right; CLQ_NONE for other kinds */
    uint64_t loop;   /* CLIP_END: the number of loops that have ended since the play began */
    clq_layer layer; /* the layer to which the clip belongs; {0}: none */
} clq_event;

/* The times after from_s, up to and including to_s. Empty if to_s <= from_s, as when time has jumped back. */
typedef struct clq_time_range {
    double from_s, to_s;
} clq_time_range;

/* Selects whether clq_crowd_get_events reports the events of an actor. Default false.
 * Fails: STALE_ID, OUT_OF_MEMORY, BUSY. */
CLQ_API clq_status clq_actor_set_watched(clq_crowd *crowd, clq_actor actor, bool watched);

/* Gets the events of all watched actors within a range of time, ordered by time, then actor, then kind. Events are a
 * function of time and of the commands: ask with the times of two successive updates, before the next commands. The
 * target of a fade, and the clips that an idle mechanism chooses, count while they are the newest one shown; the
 * distance off_m of the mechanism is not regarded.
 *   out_events   [capacity], or NULL with capacity 0: the call only counts
 *   out_count    the number of events
 * Fails: ARGUMENT (a time that is not finite), LIMIT (more events than capacity, or than a million), OUT_OF_MEMORY,
 * BUSY; nothing is written then. */
CLQ_API clq_status clq_crowd_get_events(clq_crowd *crowd, const clq_time_range *range, clq_event *out_events,
                                        size_t capacity, size_t *out_count);

/* Gets the root motion of a clip between two times (clq_template_def.root_motions): the movement over the ground that
 * its poses do not contain. A host that moves the Reference Point by it keeps the feet in place. Clips without root
 * motion give zeros.
 *   from_s, to_s   on the clip's own clock, on which start_s is its beginning; the clip loops, so any finite times will
 *                  do, in any order. The actor's time t is start_s + phase_s + speed * (t - play.start_s) on that clock
 *   out            dx and dz in model units, in the actor's space at from_s, and the rotation about y in radians
 * Fails: ARGUMENT. Threads: any. */
CLQ_API clq_status clq_template_get_root_motion(const clq_template *tmpl, uint32_t clip, double from_s, double to_s,
                                                double out[3]);

#ifdef __cplusplus
}
#endif

#endif
