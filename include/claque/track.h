/* clq_locomotion and clq_track: actors that walk where a file or a simulation says that people were.
 *
 * A locomotion is a set of clips that a template stands, walks and runs with, measured: how far each clip carries the
 * body, and when each foot carries weight. The clips play in place. A track is the path of one actor as a function of
 * time: position, heading, the phase and gait of its clips, and the places where its feet stand. All of it is computed
 * once, when the track is created, so any time can be shown without the times before it, in constant time.
 *
 * Both are immutable and are shared by any number of actors, crowds and threads. A track holds its locomotion, and a
 * crowd holds the tracks that its actors have followed until it is destroyed or clq_crowd_release_tracks is called.
 *
 * A track can be made in pieces, while it is decided where a person goes: each is a track that continues the one
 * before (clq_track_def.previous), and never changes afterwards.
 *
 * Positions are in world units, y up. A heading is an angle about y in radians: at 0 the actor looks along +z, at
 * pi / 2 along +x. Times are seconds on the track's own clock. GL: none. */
#ifndef CLAQUE_TRACK_H
#define CLAQUE_TRACK_H

#include <claque/play.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef struct clq_locomotion clq_locomotion;
typedef struct clq_track clq_track;

/* The nodes of one leg. */
typedef struct clq_leg_def {
    uint32_t thigh, shin; /* the shin below the thigh */
    uint32_t foot;        /* anywhere: rigs made for inverse kinematics hang their feet on the root */
    uint32_t toes;        /* below foot, or CLQ_NONE */
} clq_leg_def;

typedef struct clq_locomotion_def {
    uint32_t struct_bytes; /* set by clq_locomotion_def_init */
    const clq_template *tmpl;
    uint32_t walk;         /* one cycle of a walk in place, towards +z, the ground at y = 0 */
    uint32_t run;          /* the same of a run, or CLQ_NONE (default): fast people walk fast */
    uint32_t idle_count;   /* [0, 4] clips to stand with; 0: the rest pose */
    const uint32_t *idles; /* [idle_count] each stand of a track chooses one at random */
    /* Left and right. All CLQ_NONE (default): found by the nodes' names as common tools write them (LeftUpLeg,
     * thigh_l, UpperLeg.R, ...). */
    clq_leg_def legs[2];
    /* A walk with short steps, slower than `walk`, or CLQ_NONE (default): then the walk is blended with standing. */
    uint32_t slow_walk;
    uint32_t turn; /* steps on the spot, or CLQ_NONE (default): people that turn on the spot take steps of the walk */
    /* The nodes that turn with gaze and shoulders, each below the one before; each may be missing. All CLQ_NONE
     * (default): found by their names, as the legs are. */
    uint32_t torso, neck, head;
} clq_locomotion_def;

static inline clq_locomotion_def clq_locomotion_def_init(void)
{
    clq_locomotion_def def;
    int leg;
    memset(&def, 0, sizeof def);
    def.struct_bytes = (uint32_t)sizeof def;
    def.walk = def.run = def.slow_walk = def.turn = def.torso = def.neck = def.head = CLQ_NONE;
    for (leg = 0; leg < 2; ++leg)
        def.legs[leg].thigh = def.legs[leg].shin = def.legs[leg].foot = def.legs[leg].toes = CLQ_NONE;
    return def;
}

/* Measures a set of clips: poses the template some 500 times.
 *   def   copied; the locomotion holds the template
 *   out   owned by the host until clq_locomotion_destroy
 * Fails: STRUCT_SIZE, ARGUMENT (a clip or node that is missing, by name; a walk whose feet carry the body nowhere),
 * OUT_OF_MEMORY. Threads: any. */
CLQ_API clq_status clq_locomotion_create(clq_context *context, const clq_locomotion_def *def, clq_locomotion **out);

/* Releases the host's hold; NULL is ignored. Tracks keep the locomotion as long as they need it. Threads: any. */
CLQ_API void clq_locomotion_destroy(clq_locomotion *locomotion);

typedef struct clq_locomotion_info {
    uint32_t struct_bytes;         /* set by clq_locomotion_info_init */
    float walk_stride, run_stride; /* model units that a cycle carries the body; run: 0 without one */
    float walk_speed, run_speed;   /* model units a second, at the clips' own pace */
    float leg_length;              /* model units */
    clq_leg_def legs[2];           /* as given or found */
    float slow_stride, slow_speed; /* of the slow walk, as of the walk; 0 without one */
    uint32_t torso, neck, head;    /* as given or found, or CLQ_NONE */
} clq_locomotion_info;

CLQ_DEFINE_ZERO_INIT(clq_locomotion_info)

/* Gets what was measured of a set of clips.
 *   out   made by clq_locomotion_info_init
 * Fails: STRUCT_SIZE, ARGUMENT. Threads: any. */
CLQ_API clq_status clq_locomotion_get_info(const clq_locomotion *locomotion, clq_locomotion_info *out);

/* Where a person was at a time. */
typedef struct clq_track_point {
    double time_s;
    double position[3];
    float heading_rad; /* NaN: unknown; the heading then follows the path */
} clq_track_point;

/* Another person that comes close. */
typedef struct clq_track_passing {
    double time_s;
    double position[3]; /* of the other at that time */
} clq_track_passing;

typedef struct clq_track_def {
    uint32_t struct_bytes; /* set by clq_track_def_init */
    uint32_t point_count;  /* 1 or more */
    /* [point_count] times ascend, by any steps; every point within 250 km of the first */
    const clq_track_point *points;
    /* [0, 60] positions are averaged over this time, about one stride, because measured heads sway from side to side.
     * The first and the last point stay. 0: not at all. Default 1.1 */
    float smooth_s;
    float metres_per_unit; /* (> 0) as in clq_crowd_def. Default 1 */
    float scale;           /* (> 0) of the actors that will follow the track, as in clq_transform. Default 1 */
    uint64_t seed;         /* chooses idle clips and the foot that starts; all pieces of a person have the same */
    /* The piece before: this track begins where that one ends, with its place, heading, phase, gait, idle clip and
     * feet. Of the same locomotion, metres_per_unit and scale. The points begin before that end, 1.5 s or more for a
     * path like that of a whole track, and need not be those that the piece before was made of. Not held.
     * NULL (default): none */
    const clq_track *previous;
    /* Where this piece ends, seconds, 0.1 s or more after its begin. The points behind it say how the person goes on:
     * give 1 s or more, so that feet come down where the next piece has them and stands begin in time. Points up to 2 s
     * before and behind the piece are used. From the time of the last point on (default 1e300): at the last point,
     * which is then the last place of the person */
    double end_s;
    /* Others that pass, as clq_find_passings finds them. While one passes within 1 m, the torso turns by up to half a
     * radian, so that the shoulder on that side goes back; within 0.5 m it turns fully. Default: none */
    uint32_t passing_count;
    const clq_track_passing *passings; /* [passing_count] times ascend */
    /* The ground where it is not level below a person, such as stairs: called while the track is created, on the
     * calling thread, with points at the height of the person. Each step then stands on the ground at its own height,
     * and moves by up to 0.15 m along the way to stand on one tread. The hips sink where a leg would not reach. NaN, or
     * a height that no leg reaches: the foot stands at the height of the person. The heights are part of the track,
     * which needs `ground` no more. Must not call claque. NULL (default): all steps are at the person's height */
    clq_height_function ground;
    void *ground_user;
} clq_track_def;

static inline clq_track_def clq_track_def_init(void)
{
    clq_track_def def;
    memset(&def, 0, sizeof def);
    def.struct_bytes = (uint32_t)sizeof def;
    def.smooth_s = 1.1f;
    def.metres_per_unit = 1.0f;
    def.scale = 1.0f;
    def.end_s = 1e300;
    return def;
}

typedef struct clq_found_passing {
    uint32_t track; /* index of `defs` */
    clq_track_passing passing;
} clq_found_passing;

/* Finds where people come within 1 m of each other while they move against each other by 0.6 m/s or more: once for each
 * of the two. What belongs to one track stands together and ascends in time, as clq_track_def.passings wants it. Takes
 * n log n of the seconds of all tracks, and more where many people are within a metre.
 *   defs         [def_count] of the tracks that will be created; their points and metres_per_unit are read
 *   out          [capacity], or NULL with capacity 0: the call only counts
 *   out_count    the number of passings found
 * Fails: STRUCT_SIZE, ARGUMENT (names the first bad point; tracks of different metres_per_unit), LIMIT (more than
 * capacity; a track of more than 10^6 s), OUT_OF_MEMORY. Threads: any. */
CLQ_API clq_status clq_find_passings(clq_context *context, const clq_track_def *const *defs, uint32_t def_count,
                                     clq_found_passing *out, size_t capacity, size_t *out_count);

/* Creates a track. A person stands from a speed below 0.10 m/s to one above 0.25 m/s, for 0.6 s or more: position and
 * heading are then frozen and an idle clip plays; steps in between carry the person along if it drifts by 0.25 m, or
 * by 0.4 m/s times smooth_s if that is less (0.08 m at least). Slow people take short steps, first of the slow walk,
 * then blended with standing; from 1.35 times the walk's own speed on the run is blended in. The heading is that of
 * the points or follows the path; it is held below 0.25 m/s and turns by at most 3.1 radians a second. Head and neck
 * look where the heading will be half a second later, by up to 63 degrees from the body; what control mechanisms write
 * of them (claque/behave.h) is added. While a foot carries weight, a two-bone mechanism of the leg holds it where it
 * stands.
 *   def   copied
 *   out   owned by the host until clq_track_destroy
 * Fails: STRUCT_SIZE, ARGUMENT (names the first bad point), LIMIT (10^6 s), CALLBACK (`ground` threw), OUT_OF_MEMORY.
 * Threads: any. */
CLQ_API clq_status clq_track_create(const clq_locomotion *locomotion, const clq_track_def *def, clq_track **out);

/* Releases the host's hold; NULL is ignored. Threads: any. */
CLQ_API void clq_track_destroy(clq_track *track);

/* Takes another hold of a track for the host, which clq_track_destroy releases. NULL is ignored. Threads: any. */
CLQ_API void clq_track_hold(clq_track *track);

typedef struct clq_track_info {
    uint32_t struct_bytes; /* set by clq_track_info_init */
    uint32_t sample_count; /* of 16 bytes, on a uniform grid */
    double start_s, end_s;
    double rate_hz;    /* of the grid: 10 to 50 */
    double distance_m; /* travelled */
    double standing_s;
    double mean_shift_m, max_shift_m; /* between the given points and the path shown, at the times of the points */
    uint32_t plant_count;             /* times that a foot stands */
    uint64_t bytes;                   /* held */
    uint64_t hash;                    /* of the track's contents: equal tracks have equal hashes on every machine */
    uint64_t previous_hash;           /* of the piece that this one continues; 0: of none */
} clq_track_info;

CLQ_DEFINE_ZERO_INIT(clq_track_info)

/* Gets what a track holds.
 *   out   made by clq_track_info_init
 * Fails: STRUCT_SIZE, ARGUMENT. Threads: any. */
CLQ_API clq_status clq_track_get_info(const clq_track *track, clq_track_info *out);

/* A track at one time. */
typedef struct clq_track_state {
    bool present; /* the time is between start_s and end_s; before and after, the rest is that of the nearer end */
    bool stands;  /* position and heading are frozen */
    double position[3]; /* of the Reference Point, world units */
    double heading_rad;
    double phase; /* [0, 1) of the walk's cycle, and the run's */
    float gait;   /* 0 stands, 1 walks, 2 runs; clips are blended in between */
    float speed_m_s;
} clq_track_state;

/* Evaluates a track, in constant time. Fails: ARGUMENT (NULL, a time that is not finite). Threads: any. */
CLQ_API clq_status clq_track_evaluate(const clq_track *track, double time_s, clq_track_state *out);

/* A time in which a foot stands. */
typedef struct clq_track_plant {
    /* On the track's own clock; a foot that is down at an end of the track begins or ends there. */
    double begin_s, end_s;
    double position[3]; /* of the ball of the foot, on the ground, world units */
} clq_track_plant;

/* Gets when and where a foot stands, for prints, dust and sounds, and for measuring how far feet slide.
 *   foot           0 left, 1 right
 *   from_s, to_s   on the track's own clock: plants that have a time in common with this range, ascending
 *   out            [capacity], or NULL with capacity 0: the call only counts
 *   out_count      the number of plants
 * Fails: ARGUMENT (NULL, a foot above 1, a time that is not finite), LIMIT (more than capacity; nothing is written
 * then). Threads: any. */
CLQ_API clq_status clq_track_get_plants(const clq_track *track, uint32_t foot, double from_s, double to_s,
                                        clq_track_plant *out, size_t capacity, size_t *out_count);

/* Writes a track, so that it need not be created again. Equal tracks give equal bytes on every machine.
 * Fails: ARGUMENT (NULL), IO, CALLBACK, OUT_OF_MEMORY. Threads: any. */
CLQ_API clq_status clq_track_save(const clq_track *track, clq_write_function write, void *user);

/* Loads a track that clq_track_save wrote. The bytes may be anything.
 *   locomotion   measured from the same clips as that of the saved track
 *   bytes        [size_bytes], not kept
 * Fails: ARGUMENT (another locomotion), FORMAT (cut off, changed, of another version), OUT_OF_MEMORY. Threads: any. */
CLQ_API clq_status clq_track_load(const clq_locomotion *locomotion, const void *bytes, size_t size_bytes,
                                  clq_track **out);

enum { CLQ_TRACK_PIECES = 4 };

/* Lets an actor follow a track. It appears and disappears with the track; in between the track places its Reference
 * Point and plays its clips. Of its transform only the scale counts. Fades and layers end, layers may be added. A
 * member of a group cannot follow a track, and an actor that follows one cannot join a group.
 *
 * A piece that continues the track that the actor follows, with the same start_s, is added to it: the actor plays on,
 * fades and layers too, and each time is shown by its piece. Up to CLQ_TRACK_PIECES pieces are kept, the newest; times
 * before them are before the track.
 *   start_s   the time on the clock of clq_crowd_update at which the track's own clock is at 0
 * Fails: STALE_ID, ARGUMENT (a track of another template; a member of a group), OUT_OF_MEMORY, BUSY.
 * Threads: the crowd's writer. */
CLQ_API clq_status clq_actor_follow_track(clq_crowd *crowd, clq_actor actor, clq_track *track, double start_s);

/* Fades from what an actor plays back to the gait of the track that it follows. clq_actor_play and clq_actor_fade_to
 * lead from there to clips: the track then still moves the actor. While it plays the gait, its events are the steps and
 * the stands (CLQ_EVENT_STEP, CLQ_EVENT_STAND).
 *   length_s   [>= 0]
 * Fails: STALE_ID, ARGUMENT (an actor that follows no track), LIMIT, OUT_OF_MEMORY, BUSY.
 * Threads: the crowd's writer. */
CLQ_API clq_status clq_actor_fade_to_track(clq_crowd *crowd, clq_actor actor, double at_s, float length_s);

/* Ends the following of a track: the actor stays where its track has it at at_s, at every time. If it plays the track's
 * gait, it stands.
 * Fails: STALE_ID, ARGUMENT (an actor that follows no track), OUT_OF_MEMORY, BUSY. Threads: the crowd's writer. */
CLQ_API clq_status clq_actor_leave_track(clq_crowd *crowd, clq_actor actor, double at_s);

/* Makes a track known to a crowd, so that clq_crowd_restore finds it: a saved crowd names tracks by their hashes.
 * Tracks that actors of this crowd have followed are known already.
 * Fails: ARGUMENT, OUT_OF_MEMORY, BUSY. Threads: the crowd's writer. */
CLQ_API clq_status clq_crowd_add_track(clq_crowd *crowd, clq_track *track);

/* Releases every track that no actor of the crowd follows now, so that a long run of pieces needs no more memory than
 * the pieces that are shown.
 *   released   gets their number; may be NULL
 * Fails: ARGUMENT, OUT_OF_MEMORY, BUSY. Threads: the crowd's writer. */
CLQ_API clq_status clq_crowd_release_tracks(clq_crowd *crowd, uint32_t *released);

#ifdef __cplusplus
}
#endif

#endif
