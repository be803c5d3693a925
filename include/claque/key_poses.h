/* Shared key-poses (S3): poses of a clip at a uniform rate, whose skinned vertices all actors of one template and level of
 * detail share, in one update's views, from actor to actor and from frame to frame. */
#ifndef CLAQUE_KEY_POSES_H
#define CLAQUE_KEY_POSES_H

#include <claque/base.h>

#ifdef __cplusplus
extern "C" {
#endif

struct clq_crowd;

/* How an actor comes by its vertices. What each method shows is a function of the actor's tick; how many key-poses are kept
 * changes only what that costs. Actors that more than one clip moves (fades, control mechanisms, degrees of freedom), or
 * none, are INDIVIDUAL whatever is said here.
 *
 * What key-poses are wrong by against the exact pose falls with the rate for the nearest one, with its square for two blended.
 * The built-in people at 15 key-poses a second: no vertex by more than 120 mm (9 mm root mean square), and 30 mm (2 mm);
 * within a pixel of a picture 768 lines high over 60 degrees from 80 m on, and from 20 m on. Packed geometry adds one of its
 * steps along each axis at most. */
typedef enum clq_key_pose_mode {
    CLQ_KEY_POSE_INDIVIDUAL = 0, /* the pose of its tick, in caches of its own (S1 4) */
    CLQ_KEY_POSE_INTERMITTENT =
        1, /* the key-pose nearest to its tick: half an interval early or late at most (S3 3). The cheapest */
    CLQ_KEY_POSE_INTERPOLATED = 2, /* the two key-poses round its tick, positions and normals blended linearly (S3 4) */
    CLQ_KEY_POSE_SKINNED = 3       /* the pose of each update's own time, skinned anew every time */
} clq_key_pose_mode;

/* Of actors from `distance` to the nearest eye on, world units, up to the next band. */
typedef struct clq_key_pose_band {
    float distance;
    clq_key_pose_mode mode;
} clq_key_pose_band;

#define CLQ_KEY_POSE_BAND_MAX 4

typedef struct clq_key_poses {
    /* [band_count] distances ascend, finite, from 0 on. Who is nearer than the first is INDIVIDUAL; so is everybody where
     * there is none, which is the default. One band at distance 0: a method for the whole crowd. */
    clq_key_pose_band bands[CLQ_KEY_POSE_BAND_MAX];
    uint32_t band_count;
    float rate_hz;         /* [0.5, 120] key-poses a second of each clip, so that they divide it evenly. Default 15 */
    uint32_t max_kept;     /* key-poses kept skinned for each template and level; may be 0. Default 256 */
    uint64_t budget_bytes; /* of all that are kept; 0: 256 MiB */
} clq_key_poses;

static inline clq_key_poses clq_key_poses_init(void)
{
    clq_key_poses key_poses;
    int i;
    for (i = 0; i < CLQ_KEY_POSE_BAND_MAX; ++i) {
        key_poses.bands[i].distance = 0.0f;
        key_poses.bands[i].mode = CLQ_KEY_POSE_INDIVIDUAL;
    }
    key_poses.band_count = 0;
    key_poses.rate_hz = 15.0f;
    key_poses.max_kept = 256;
    key_poses.budget_bytes = 0;
    return key_poses;
}

/* Of the last update (S3 Figs. 11 and 12). */
typedef struct clq_key_pose_stats {
    uint32_t requested; /* actors that show key-poses */
    uint32_t served;    /* of these, whose key-poses are all kept; the others are skinned */
    uint32_t wanted;    /* different key-poses that they show, over templates and levels */
    uint32_t
        updated;    /* key-poses skinned in this update to be kept: each once, whoever shows it in however many views */
    uint32_t held;  /* kept now */
    uint64_t bytes; /* that they take */
} clq_key_pose_stats;

/* Fails: ARGUMENT. Threads: any, not during an update. GL: none. */
CLQ_API clq_status clq_crowd_get_key_pose_stats(const struct clq_crowd *crowd, clq_key_pose_stats *out);

/* Individuals with equal needs (S3 4.2: a temporal bin). */
typedef struct clq_key_pose_bin {
    uint32_t first, second; /* key-poses; equal where one is all they need */
    uint32_t count;         /* of individuals */
} clq_key_pose_bin;

/* The choice by itself that an update makes for each template and level: which key-poses to keep so that many are served. A
 * set-union knapsack (S3 4.2), solved greedily: whatever key-pose the fewest would miss goes, until the rest finds room; what
 * room is then left goes to the fullest bins that fit. Ties: lower numbers stay.
 *   bins         [bin_count]
 *   out_chosen   [pose_count], 1: kept; at most `capacity` of them
 * Fails: ARGUMENT (a key-pose that is not below pose_count), OUT_OF_MEMORY. Threads: any. GL: none. */
CLQ_API clq_status clq_key_poses_choose(const clq_key_pose_bin *bins, uint32_t bin_count, uint32_t pose_count,
                                        uint32_t capacity, uint8_t *out_chosen);

#ifdef __cplusplus
}
#endif

#endif
