/* More than one clip at a time (S2 3.3): cross-fades and inertial ones, two gaits in step, layers over parts of the body;
 * clips drawn by lot; events of clips; ways that clips go.
 *
 * What an actor shows is a function of time and of what was commanded: any moment shows itself, whichever were shown before.
 * The last three fades and four layers of an actor are remembered, at most eight clips together; a command for which there
 * is no room beside what still runs at its moment is LIMIT. What is over makes room from the oldest on, and moments before
 * then show what the oldest that is left began from. Poses are blended joint by joint, rotations by the shorter arc. While
 * an actor remembers fades or layers its bounding spheres hold every blend of its template's clips; clq_actor_play ends that.
 *
 * Everything here is for the crowd's writer; GL: none. */
#ifndef CLAQUE_PLAY_H
#define CLAQUE_PLAY_H

#include <claque/crowd.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Of one crowd; zero is none. They live as long as it. */
typedef struct clq_gait {
    uint32_t index1;
} clq_gait;
typedef struct clq_mask {
    uint32_t index1;
} clq_mask;

/* How a change goes over its time. */
typedef enum clq_curve {
    CLQ_CURVE_LINEAR = 0,
    CLQ_CURVE_SMOOTH = 1, /* starts and ends without a jerk */
    /* Fades of single clips only: the new clip is shown at once, and on top of it what the actor was off from it, place and
     * velocity, which decays. The old clip stops, so that it costs nothing to leave it in the middle of a movement. */
    CLQ_CURVE_INERTIAL = 2
} clq_curve;

/* Two clips of one cycle each, as long as they are, that are shown at one common phase. */
typedef struct clq_gait_def {
    uint32_t struct_bytes;    /* set by clq_gait_def_init */
    const clq_template *tmpl; /* used by at least one actor already */
    uint32_t clip_a, clip_b;
    /* Moments that belong together, as when a foot comes down, on each clip's own axis: ascending, in its length, from one
     * cycle's beginning to its end. 0: equal shares of the cycles belong together. Or the name of markers that both clips
     * have equally many of. */
    uint32_t sync_count;
    const float *sync_a_s, *sync_b_s; /* [sync_count] */
    const char *sync_marker;          /* with sync_count 0; NULL: none */
} clq_gait_def;

static inline clq_gait_def clq_gait_def_init(void)
{
    clq_gait_def def;
    unsigned char *p = (unsigned char *)&def;
    size_t i;
    for (i = 0; i < sizeof def; ++i) p[i] = 0;
    def.struct_bytes = (uint32_t)sizeof def;
    return def;
}

/* Fails: STRUCT_SIZE, ARGUMENT (the first broken rule, named), OUT_OF_MEMORY. */
CLQ_API clq_status clq_crowd_add_gait(clq_crowd *crowd, const clq_gait_def *def, clq_gait *out);

/* A joint mask: nodes by name, each with all below it. */
typedef struct clq_mask_def {
    uint32_t struct_bytes;    /* set by clq_mask_def_init */
    const clq_template *tmpl; /* used by at least one actor already */
    uint32_t node_count;
    const char *const *nodes; /* [node_count] names of the template's nodes */
    uint32_t feather;         /* over so many nodes down from the named ones the weight grows to 1; 0: at once */
    int32_t inverted;         /* 1: all but these */
} clq_mask_def;

static inline clq_mask_def clq_mask_def_init(void)
{
    clq_mask_def def;
    unsigned char *p = (unsigned char *)&def;
    size_t i;
    for (i = 0; i < sizeof def; ++i) p[i] = 0;
    def.struct_bytes = (uint32_t)sizeof def;
    return def;
}

/* Fails: STRUCT_SIZE, ARGUMENT (a name that no node has), OUT_OF_MEMORY. */
CLQ_API clq_status clq_crowd_add_mask(clq_crowd *crowd, const clq_mask_def *def, clq_mask *out);

/* What a fade goes to: a clip, or two gaits. */
typedef struct clq_fade_target {
    clq_play play; /* of a gait: start, speed and phase of its first clip; `clip` is not read */
    clq_gait gait; /* zero: the clip */
    float share;   /* [0, 1] of the gait's second clip */
} clq_fade_target;

/* Goes over to something else. Gaits go in step with each other, not with what they come from.
 *   at_s       when it begins, on the update's clock; times before show what was commanded before. A fade for an earlier time
 *              than that of others replaces those
 *   length_s   [>= 0] that it takes
 * Fails: STALE_ID, ARGUMENT, LIMIT, UNSUPPORTED (an inertial fade of a gait), OUT_OF_MEMORY. */
CLQ_API clq_status clq_actor_fade_to(clq_crowd *crowd, clq_actor actor, const clq_fade_target *to, double at_s,
                                     float length_s, clq_curve curve);

/* Changes the share of the second gait that an actor shows, from what it is at at_s, smoothly within length_s; the pace
 * follows, and the phase goes on. Times before at_s show the pace of at_s: of shares only the last change is remembered.
 * Fails: STALE_ID, ARGUMENT (it plays no gait), OUT_OF_MEMORY. */
CLQ_API clq_status clq_actor_set_gait_share(clq_crowd *crowd, clq_actor actor, float share, double at_s,
                                            float length_s);

/* A layer of an actor; zero is none. */
typedef struct clq_layer {
    uint32_t index1;
} clq_layer;

typedef enum clq_layer_kind {
    CLQ_LAYER_REPLACE = 0, /* in place of what is below */
    CLQ_LAYER_ADD = 1      /* its difference from a reference pose, on top of what is below */
} clq_layer_kind;

typedef struct clq_layer_def {
    uint32_t struct_bytes; /* set by clq_layer_def_init */
    clq_layer_kind kind;
    clq_play play;               /* shown from play.start_s on */
    float weight;                /* REPLACE: [0, 1]; ADD: [-4, 4]. Default 1 */
    float loops;                 /* [>= 0] of the clip until it is over, fades included; 0: until clq_actor_end_layer */
    float fade_in_s, fade_out_s; /* [>= 0] */
    clq_curve curve;             /* LINEAR or SMOOTH. Default SMOOTH */
    clq_mask mask;               /* zero: the whole body */
    /* ADD: the reference. Default: the first moment of the layer's own clip. */
    int32_t has_reference; /* 1: the pose of this clip (CLQ_NONE: at rest) at this time on its own axis */
    uint32_t reference_clip;
    float reference_time_s;
} clq_layer_def;

static inline clq_layer_def clq_layer_def_init(void)
{
    clq_layer_def def;
    unsigned char *p = (unsigned char *)&def;
    size_t i;
    for (i = 0; i < sizeof def; ++i) p[i] = 0;
    def.struct_bytes = (uint32_t)sizeof def;
    def.play.clip = CLQ_NONE;
    def.play.speed = 1.0f;
    def.weight = 1.0f;
    def.curve = CLQ_CURVE_SMOOTH;
    return def;
}

/* Lays a clip over what an actor shows, above the layers that it has. A layer that is over vanishes.
 *   out   may be NULL
 * Fails: STRUCT_SIZE, STALE_ID, ARGUMENT, LIMIT, OUT_OF_MEMORY. */
CLQ_API clq_status clq_actor_add_layer(clq_crowd *crowd, clq_actor actor, const clq_layer_def *def, clq_layer *out);

/* Lets a layer go from at_s on, within fade_out_s; one that would be over before is left alone.
 * Fails: STALE_ID (also of a layer that is forgotten), ARGUMENT, OUT_OF_MEMORY. */
CLQ_API clq_status clq_actor_end_layer(clq_crowd *crowd, clq_actor actor, clq_layer layer, double at_s,
                                       float fade_out_s);

/* Clips by lot (S0 7.1): the noise that keeps a crowd from moving as one. */
typedef struct clq_random_play_def {
    uint32_t struct_bytes; /* set by clq_random_play_def_init */
    uint32_t clip_count;
    const uint32_t *clips;
    const float *weights; /* [clip_count], each >= 0, not all 0: what share of the lots each has; NULL: equal */
    float speed_spread;   /* [0, 1) speeds are 1 - this to 1 + this */
    float phase_spread;   /* [0, 1] of the clip's length: where in it it begins */
} clq_random_play_def;

static inline clq_random_play_def clq_random_play_def_init(void)
{
    clq_random_play_def def;
    unsigned char *p = (unsigned char *)&def;
    size_t i;
    for (i = 0; i < sizeof def; ++i) p[i] = 0;
    def.struct_bytes = (uint32_t)sizeof def;
    return def;
}

/* Draws a clip, a speed and a phase from the seeds of crowd and actor, for clq_actor_play or a fade.
 *   draw      which of the actor's draws: the same number draws the same again
 *   start_s   of the play
 * Changes nothing. Fails: STRUCT_SIZE, STALE_ID, ARGUMENT. */
CLQ_API clq_status clq_actor_sample_play(const clq_crowd *crowd, clq_actor actor, const clq_random_play_def *def,
                                         uint32_t sample_index, double start_s, clq_play *out);

/* The clips that an actor shows at a moment, in the order in which they are blended, as the finest level has them. */
typedef struct clq_active_clip {
    uint32_t clip; /* CLQ_NONE: the rest pose */
    double clip_time_s;
    float weight;
    clq_layer_kind kind;
} clq_active_clip;

#define CLQ_ACTIVE_CLIP_MAX 8

/* Fails: STALE_ID, ARGUMENT. */
CLQ_API clq_status clq_actor_get_active_clips(const clq_crowd *crowd, clq_actor actor, double time_s,
                                              clq_active_clip out[CLQ_ACTIVE_CLIP_MAX], uint32_t *out_count);

/* Events: what happens in an actor's clips, whoever sees it. */
typedef enum clq_event_kind {
    CLQ_EVENT_MARKER = 0,   /* the clip passes one of its markers */
    CLQ_EVENT_CLIP_END = 1, /* a round of the clip ends; the next one begins */
    CLQ_EVENT_FADE_END = 2, /* a fade is over */
    CLQ_EVENT_LAYER_END = 3 /* a layer is over */
} clq_event_kind;

typedef struct clq_event {
    double time_s; /* on the update's clock */
    clq_actor actor;
    clq_event_kind kind;
    uint32_t clip;   /* that is played; of a gait its first one; of a fade what it went to */
    uint32_t marker; /* for clq_template_get_marker; else CLQ_NONE */
    uint64_t loop;   /* CLIP_END: how many have ended since the play began */
    clq_layer layer; /* of a layer's clip; else zero */
} clq_event;

/* Asks for an actor's events, or for none: nobody is asked about unless it was. Fails: STALE_ID, OUT_OF_MEMORY. */
CLQ_API clq_status clq_actor_watch(clq_crowd *crowd, clq_actor actor, int32_t watched);

/* The events after from_s, up to and with to_s, of all who are watched: in the order of time, those of one time in that of
 * actors, of one actor in that of kinds. They are a function of time and of commands, as poses are: ask with the times of two
 * updates that follow each other, before the next commands. A fade's target, and whatever an idle mechanism draws, count from
 * when they begin to be shown until the next; off_m of mechanisms does not matter. to_s <= from_s, as when time has
 * jumped back: none.
 *   events     [capacity], or NULL with capacity 0: how many there are
 * Fails: ARGUMENT (not finite), LIMIT (more than capacity, or than a million; nothing is written then). */
CLQ_API clq_status clq_crowd_get_events(clq_crowd *crowd, double from_s, double to_s, clq_event *events,
                                        size_t capacity, size_t *out_count);

/* The way that a clip goes over the ground, which its poses do not hold (clq_template_def.root_motions): from one moment to
 * another, in the space of the actor as it stands at from_s: dx, dz in model units and the turn about y in radians. Move
 * the Reference Point by it, and feet stay where they are.
 *   from_s, to_s   on the clip's own clock: start_s is its beginning; it goes round, so any finite time will do, to_s may be
 *                  less. At actor's time t that is start_s + phase_s + speed * (t - play.start_s)
 * Of a clip that goes nowhere: zeros. Fails: ARGUMENT. Threads: any. */
CLQ_API clq_status clq_template_get_root_motion(const clq_template *tmpl, uint32_t clip, double from_s, double to_s,
                                                double out[3]);

#ifdef __cplusplus
}
#endif

#endif
