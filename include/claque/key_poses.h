/* Shared key-poses (S3): poses of a clip at a uniform rate. All actors of one template and level of detail share their
 * skinned vertices, within the views of an update and from frame to frame. */
#ifndef CLAQUE_KEY_POSES_H
#define CLAQUE_KEY_POSES_H

#include <claque/base.h>

#ifdef __cplusplus
extern "C" {
#endif

struct clq_crowd;

/* How an actor gets its vertices. The picture of each mode is a function of the actor's tick; the number of key-poses
 * kept changes only the cost. Actors that several clips move (fades, layers, control mechanisms, degrees of freedom),
 * and actors without a clip, are always INDIVIDUAL.
 *
 * The error against the exact pose falls linearly with the rate (INTERMITTENT) or quadratically (INTERPOLATED). For the
 * built-in people at 15 key-poses a second it is at most 120 mm (9 mm root mean square) and 30 mm (2 mm). In a picture
 * of 768 lines over 60 degrees that is within a pixel from 80 m on and from 20 m on. The packed vertex format adds at
 * most one of its steps along each axis. */
typedef enum clq_key_pose_mode {
    /* The pose of the actor's tick, in caches of its own (S1 4). */
    CLQ_KEY_POSE_INDIVIDUAL = 0,
    /* The key-pose nearest to the actor's tick, at most half an interval early or late (S3 3). The cheapest mode. */
    CLQ_KEY_POSE_INTERMITTENT = 1,
    /* A linear blend of the positions and normals of the two key-poses around the tick (S3 4). */
    CLQ_KEY_POSE_INTERPOLATED = 2,
    /* The pose of the update's own time, skinned anew in every update. */
    CLQ_KEY_POSE_SKINNED = 3
} clq_key_pose_mode;

/* The mode of actors whose eyeDistance is at least distance_min_m and less than that of the next band. */
typedef struct clq_key_pose_band {
    float distance_min_m;
    clq_key_pose_mode mode;
} clq_key_pose_band;

#define CLQ_KEY_POSE_BAND_MAX 4

/* The settings of key-poses in clq_crowd_def. */
typedef struct clq_key_poses {
    /* [band_count] distances are finite, 0 or more, and ascend. Actors nearer than the first band are INDIVIDUAL. One
     * band at 0 m sets one mode for the whole crowd. */
    clq_key_pose_band bands[CLQ_KEY_POSE_BAND_MAX];
    uint32_t band_count; /* default 0: all actors are INDIVIDUAL */
    /* [0.5, 120] key-poses per second of each clip, adjusted to divide it evenly. Default 15. A template
     * has about 131 000 at most. If its clips are longer in total, the rate is lower. */
    float rate_hz;
    uint32_t max_kept;     /* key-poses kept skinned for each template and level; may be 0. Default 256 */
    uint64_t budget_bytes; /* memory of all kept key-poses; 0 (default): 256 MiB */
} clq_key_poses;

static inline clq_key_poses clq_key_poses_init(void)
{
    clq_key_poses key_poses;
    memset(&key_poses, 0, sizeof key_poses);
    key_poses.rate_hz = 15.0f;
    key_poses.max_kept = 256;
    return key_poses;
}

/* Counts of the last update (S3 Figs. 11 and 12). */
typedef struct clq_key_pose_stats {
    uint32_t struct_bytes; /* set by clq_key_pose_stats_init */
    uint32_t requested;    /* actors that show key-poses */
    uint32_t served;       /* of these, actors whose key-poses are all kept; the others are skinned */
    uint32_t wanted;       /* distinct key-poses that they show, over all templates and levels */
    uint32_t updated;      /* key-poses skinned in this update to be kept, each once for all its actors and views */
    uint32_t held;         /* key-poses kept now */
    uint64_t bytes;        /* memory of the kept key-poses */
} clq_key_pose_stats;

CLQ_DEFINE_ZERO_INIT(clq_key_pose_stats)

/* Gets the counts of the last update.
 *   out   made by clq_key_pose_stats_init
 * Fails: STRUCT_SIZE, ARGUMENT, BUSY. Threads: any. GL: none. */
CLQ_API clq_status clq_crowd_get_key_pose_stats(const struct clq_crowd *crowd, clq_key_pose_stats *out);

/* A temporal bin: individuals that need the same key-poses (S3 4.2). */
typedef struct clq_key_pose_bin {
    uint32_t first, second; /* indices of key-poses; equal if the individuals need only one */
    uint32_t count;         /* individuals */
} clq_key_pose_bin;

/* Makes the choice that an update makes for each template and level: the key-poses to keep so that many individuals are
 * served. This is a set-union knapsack (S3 4.2), solved greedily. The key-pose that the fewest individuals need is
 * dropped until the rest fits; the room that is left then goes to the fullest bins that fit. Of equals the lower index
 * stays.
 *   bins         [bin_count], with indices below pose_count
 *   max_kept     key-poses to keep at most
 *   out_chosen   [pose_count], true: kept
 * Fails: ARGUMENT, OUT_OF_MEMORY. Threads: any. GL: none. */
CLQ_API clq_status clq_key_poses_choose(const clq_key_pose_bin *bins, uint32_t bin_count, uint32_t max_kept,
                                        bool *out_chosen, uint32_t pose_count);

#ifdef __cplusplus
}
#endif

#endif
