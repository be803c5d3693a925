/* clq_navigation and clq_walkers (libclaque-stage): people that find their way and give way to each other.
 *
 * A navigation is the ground on which people can walk, made once from triangles by Recast: a scene's geometry, or a
 * clq_area (claque/trajectories.h). Walkers are people on it: each gets goals, finds its way by Detour, and keeps
 * apart from the others, in ticks of fixed length: bodies that do not overlap never will (docs/navigation.md). They
 * publish what they did as pieces of tracks (claque/track.h), which never change afterwards; any crowd shows them.
 * The result is a function of the calls: equal calls give equal bits, whatever the threads.
 *
 * Positions are in world units, y up; what is called _m is in metres. GL: none.
 * Memory comes from the C and C++ heap, not from a context's allocator: Recast and Detour have one allocator for the
 * whole process, which belongs to the host. */
#ifndef CLAQUE_NAVIGATION_H
#define CLAQUE_NAVIGATION_H

#include <claque/stage.h>
#include <claque/track.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef struct clq_navigation clq_navigation;
typedef struct clq_walkers clq_walkers;

/* The upright prism over a convex polygon. */
typedef struct clq_prism {
    uint32_t point_count; /* [3, 32] in order round the polygon, either way */
    const double *points; /* [2 * point_count] x and z */
    double min_y, max_y;
} clq_prism;

/* A part of the ground beside the ways, such as the strip before a row of seats. A walker enters it only if its goal
 * lies in a byway of the same group, and may leave it anywhere. */
typedef struct clq_byway {
    clq_prism prism;
    uint32_t group; /* [0, CLQ_BYWAY_GROUPS - 1] */
} clq_byway;
#define CLQ_BYWAY_GROUPS 13

typedef struct clq_navigation_def {
    uint32_t struct_bytes; /* set by clq_navigation_def_init */
    uint32_t vertex_count, triangle_count;
    const double *vertices;    /* [3 * vertex_count] */
    const uint32_t *triangles; /* [3 * triangle_count] counter-clockwise seen from where people could stand on them */
    /* Volumes without walkable ground, besides ground that is too steep, too low or too narrow. */
    uint32_t hole_count;
    const clq_prism *holes;
    /* [0, 62] parts of the ground that open and close, at first open. They overlap with no other. */
    uint32_t door_count;
    const clq_prism *doors;
    /* With g the highest group of a byway, there are at most 61 - g doors. Byways overlap with no door and with no
     * byway of another group. */
    uint32_t byway_count;
    const clq_byway *byways;
    float metres_per_unit; /* (> 0) as in clq_crowd_def. Default 1 */
    float radius_m; /* [0.05, 5] of the widest person: how far from walls the middle of a person stays. Default 0.2 */
    float height_m; /* [0.2, 10] of the tallest person. Default 1.9 */
    float max_slope_deg; /* [0, 85] default 40 */
    float max_step_m;    /* [0, 2] default 0.25 */
    float cell_m;        /* [0.02, 2] of the grid; widths are right to a cell. 0 (default): half of radius_m */
    /* Most cells that all triangles cover, of some 40 bytes each. Default 40 000 000 */
    uint64_t max_cells;
} clq_navigation_def;

static inline clq_navigation_def clq_navigation_def_init(void)
{
    clq_navigation_def def;
    memset(&def, 0, sizeof def);
    def.struct_bytes = (uint32_t)sizeof def;
    def.metres_per_unit = 1.0f;
    def.radius_m = 0.2f;
    def.height_m = 1.9f;
    def.max_slope_deg = 40.0f;
    def.max_step_m = 0.25f;
    def.max_cells = 40000000;
    return def;
}

/* Makes a navigation.
 *   def   copied
 *   out   owned by the host until clq_navigation_destroy
 * Fails: STRUCT_SIZE, ARGUMENT (names the number, vertex, triangle or prism; no ground to walk on; a door without
 * ground), LIMIT (max_cells; 16384 tiles of 128 cells; 8000 cells of height; 4 million triangles), OUT_OF_MEMORY.
 * Recast ends the process where the heap refuses it memory. Threads: any. */
CLQ_API clq_status clq_navigation_create(const clq_navigation_def *def, clq_navigation **out);

/* Releases the host's hold; NULL is ignored. Walkers keep their navigation. Threads: any. */
CLQ_API void clq_navigation_destroy(clq_navigation *navigation);

typedef struct clq_navigation_info {
    uint32_t struct_bytes; /* set by clq_navigation_info_init */
    uint32_t tile_count, polygon_count, door_count;
    double area_m2; /* of the ground on which the middle of a person can be */
    double box_min[3], box_max[3];
    uint64_t bytes;
} clq_navigation_info;

CLQ_DEFINE_ZERO_INIT(clq_navigation_info)

/* Gets what a navigation holds.
 *   out   made by clq_navigation_info_init
 * Fails: STRUCT_SIZE, ARGUMENT. Threads: any. */
CLQ_API clq_status clq_navigation_get_info(const clq_navigation *navigation, clq_navigation_info *out);

/* Opens and closes a door. Ways through a closed door end before it. A walker that stands in one walks out.
 * Fails: ARGUMENT. Threads: any; calls on one navigation and its walkers wait for each other. */
CLQ_API clq_status clq_navigation_set_door(clq_navigation *navigation, uint32_t door, bool open);
CLQ_API clq_status clq_navigation_get_door(const clq_navigation *navigation, uint32_t door, bool *open);

/* Finds the point of the ground nearest to a point.
 *   reach   (> 0) world units to either side, up and down
 *   found   false: there is no ground that near; `out` is then left alone
 * Fails: ARGUMENT. Threads: as clq_navigation_set_door. */
CLQ_API clq_status clq_navigation_find_nearest(const clq_navigation *navigation, const double point[3], double reach,
                                               double out[3], bool *found);

typedef struct clq_way {
    uint32_t struct_bytes; /* set by clq_way_init */
    bool complete;         /* false: the way ends as near to the goal as one can get */
    uint32_t point_count;  /* of the way, also where fewer were wanted; 0: an end is not near any ground */
    double length;         /* world units */
} clq_way;

CLQ_DEFINE_ZERO_INIT(clq_way)

/* Finds the way between two points, which are moved to the ground within 2 m. Closed doors bar it.
 *   points       [3 * max_points] gets the corners with both ends; may be NULL if max_points is 0
 *   max_points   [0, 256]; ways of more corners end at the last one
 * Fails: STRUCT_SIZE, ARGUMENT, OUT_OF_MEMORY. Threads: as clq_navigation_set_door. */
CLQ_API clq_status clq_navigation_find_way(const clq_navigation *navigation, const double from[3], const double to[3],
                                           uint32_t max_points, double *points, clq_way *out);

/* People who hurry, shoulders turned: doors of 0.5 and 3 m let as many through as were measured with volunteers. */
#define CLQ_HURRIED_TIME_GAP_S 0.8f
#define CLQ_HURRIED_RADIUS_M 0.17f

typedef struct clq_walkers_def {
    uint32_t struct_bytes; /* set by clq_walkers_def_init */
    uint32_t max_count;    /* [1, 16000] walkers at one time. Default 500 */
    float max_radius_m;    /* [0.05, 2] of their bodies. Default 0.3 */
    double start_s;        /* the clock of walkers and of their tracks begins here */
    double tick_s;         /* [0.01, 0.2] default 0.05 */
    uint32_t piece_ticks;  /* [2, 200] of a piece of a track. Default 10 */
    uint32_t plans;        /* [1, 16000] ways that are found in a tick; further ones wait. Default 32 */
    float smooth_s;        /* [0, 2] as in clq_track_def. Default 0.6: walkers do not sway as measured heads do */
    /* [0, 5] seconds that a walker keeps to the one ahead: its speed is at most the gap between the bodies, 0.3 s
     * later, divided by this; its part beyond 0.7 m by 0.5 s. 0: full speed until it would touch. Default 1.2 */
    float time_gap_s;
    /* As in clq_track_def: where feet stand on stairs that the navigation has as ramps. Called by clq_walkers_step or
     * clq_stage_step, on the calling thread; the same after a restore. NULL (default): on the navigation's ground */
    clq_height_function ground;
    void *ground_user;
    float climbing, descending; /* [0.01, 1] speeds on stairs over that on the level. Default 0.455, 0.518 */
} clq_walkers_def;

static inline clq_walkers_def clq_walkers_def_init(void)
{
    clq_walkers_def def;
    memset(&def, 0, sizeof def);
    def.struct_bytes = (uint32_t)sizeof def;
    def.max_count = 500;
    def.max_radius_m = 0.3f;
    def.tick_s = 0.05;
    def.piece_ticks = 10;
    def.plans = 32;
    def.smooth_s = 0.6f;
    def.time_gap_s = 1.2f;
    def.climbing = 0.455f, def.descending = 0.518f;
    return def;
}

/* Makes a set of walkers, at first empty.
 *   navigation   held
 *   def          copied; NULL means clq_walkers_def_init()
 *   out          owned by the host until clq_walkers_destroy
 * Fails: STRUCT_SIZE, ARGUMENT, OUT_OF_MEMORY. Threads: any. */
CLQ_API clq_status clq_walkers_create(clq_navigation *navigation, const clq_walkers_def *def, clq_walkers **out);

/* Destroys walkers; NULL is ignored. Tracks that crowds follow live on. Threads: no other call may use them. */
CLQ_API void clq_walkers_destroy(clq_walkers *walkers);

/* The id of a walker. {0, 0} is none; that of a removed walker is STALE_ID. */
typedef struct clq_walker {
    uint32_t index1, generation;
} clq_walker;

typedef struct clq_walker_def {
    uint32_t struct_bytes;            /* set by clq_walker_def_init */
    const clq_locomotion *locomotion; /* of its template, held by the host; NULL (default): it publishes no pieces */
    double position[3];               /* within 2 m of the ground, to which it is moved */
    float heading_rad;                /* as in clq_track_point */
    float radius_m;                   /* [0.05, max_radius_m] of its body; 0.85 with turned shoulders. Default 0.2 */
    float speed_m_s;                  /* (0, 8] that it likes. Default 1.34 */
    float acceleration_m_s2;          /* [0.1, 50] default 4 */
    float scale;                      /* (> 0) of its actor, as in clq_transform. Default 1 */
    uint64_t seed;                    /* of its tracks */
} clq_walker_def;

static inline clq_walker_def clq_walker_def_init(void)
{
    clq_walker_def def;
    memset(&def, 0, sizeof def);
    def.struct_bytes = (uint32_t)sizeof def;
    def.radius_m = 0.2f;
    def.speed_m_s = 1.34f;
    def.acceleration_m_s2 = 4.0f;
    def.scale = 1.0f;
    return def;
}

/* Adds a walker that stands, from now on.
 * Fails: STRUCT_SIZE, ARGUMENT (a number; no ground near the position), LIMIT (max_count), OUT_OF_MEMORY.
 * Threads: one call on these walkers at a time. */
CLQ_API clq_status clq_walkers_add(clq_walkers *walkers, const clq_walker_def *def, clq_walker *out);

/* Removes a walker. Its last piece stays. Fails: ARGUMENT, STALE_ID. Threads: as clq_walkers_add. */
CLQ_API clq_status clq_walkers_remove(clq_walkers *walkers, clq_walker walker);

/* Sends a walker to a goal: it goes as near as it can, and has arrived within near_m, or behind others that stand
 * there. Replaces its goal.
 *   near_m      [0.05, 100]
 *   speed_m_s   [0, 8] 0: its own
 * Fails: ARGUMENT (no ground within 2 m of the goal), STALE_ID. Threads: as clq_walkers_add. */
CLQ_API clq_status clq_walker_go(clq_walkers *walkers, clq_walker walker, const double goal[3], float near_m,
                                 float speed_m_s);

/* Ends a walker's goal: it stops. Fails: ARGUMENT, STALE_ID. Threads: as clq_walkers_add. */
CLQ_API clq_status clq_walker_stop(clq_walkers *walkers, clq_walker walker);

typedef enum clq_walker_state {
    CLQ_WALKER_STANDS = 0, /* it has no goal. It makes room for walkers that cannot pass, and comes back */
    CLQ_WALKER_WAITS = 1,  /* for its way to be found */
    CLQ_WALKER_WALKS = 2,
    CLQ_WALKER_ARRIVED = 3,
    CLQ_WALKER_BLOCKED = 4 /* it stands where its way ends: none leads to the goal. It goes on when a door opens */
} clq_walker_state;

typedef struct clq_walker_info {
    uint32_t struct_bytes; /* set by clq_walker_info_init */
    clq_walker_state state;
    double position[3];
    float velocity_m_s[3];
    double last_piece_s; /* end of its last piece */
} clq_walker_info;

CLQ_DEFINE_ZERO_INIT(clq_walker_info)

/* Gets the state of a walker.
 *   out   made by clq_walker_info_init
 * Fails: STRUCT_SIZE, ARGUMENT, STALE_ID. Threads: as clq_walkers_add. */
CLQ_API clq_status clq_walkers_get_walker(const clq_walkers *walkers, clq_walker walker, clq_walker_info *out);

/* A piece of the track of a walker, on the clock of the walkers: follow it with start_s 0. */
typedef struct clq_walker_piece {
    clq_walker walker;
    clq_track *track; /* lives until the next piece of this walker, or as long as a crowd follows it */
    double begin_s, end_s;
} clq_walker_piece;

/* Moves all walkers on by a tick. Every walker with a locomotion publishes a piece each piece_ticks, at a tick of its
 * own. The piece holds what the walker has done; only the steps at its end need a guess of what it will do.
 * Fails: ARGUMENT, OUT_OF_MEMORY, CALLBACK (`ground` threw; after both the walkers have moved, and the next step first
 * makes the pieces that are missing, and gives all of both ticks). Threads: as clq_walkers_add. */
CLQ_API clq_status clq_walkers_step(clq_walkers *walkers);

/* Gets the pieces that the last step published, by walker. The array lives until the next step. Fails: ARGUMENT.
 * Threads: as clq_walkers_add. */
CLQ_API clq_status clq_walkers_get_pieces(const clq_walkers *walkers, const clq_walker_piece **out, uint32_t *count);

typedef struct clq_walkers_info {
    uint32_t struct_bytes;   /* set by clq_walkers_info_init */
    uint32_t count, waiting; /* walkers; of these, walkers that wait for a way */
    double time_s;
    uint64_t ticks, plans, pieces; /* so far: plans are searches for a way */
    uint64_t hash;                 /* of places and velocities: equal runs have equal hashes */
} clq_walkers_info;

CLQ_DEFINE_ZERO_INIT(clq_walkers_info)

/* Gets the counts of a set of walkers.
 *   out   made by clq_walkers_info_init
 * Fails: STRUCT_SIZE, ARGUMENT. Threads: as clq_walkers_add. */
CLQ_API clq_status clq_walkers_get_info(const clq_walkers *walkers, clq_walkers_info *out);

/* Lets the agents of a stage walk: those whose template has a locomotion in clq_machine_def.locomotions. Walkers are
 * simulated one piece ahead of the time that is decided, so they turn to a new goal half a second later. Call it before
 * the first agent.
 *   navigation    held
 *   def           copied; start_s is that of the stage. NULL: clq_walkers_def_init()
 *   locomotions   [locomotion_count] those of all machines, in an order that is the same in each run; they live as
 *                 long as the stage. Saved stages name them by number
 * Fails: STRUCT_SIZE, ARGUMENT, OUT_OF_MEMORY. Threads: the decisions' flow. */
CLQ_API clq_status clq_stage_set_navigation(clq_stage *stage, clq_navigation *navigation, const clq_walkers_def *def,
                                            const clq_locomotion *const *locomotions, uint32_t locomotion_count);

#ifdef __cplusplus
}
#endif

#endif
