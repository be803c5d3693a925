/* How fast the host moves actors and groups. claque sees where they are at a time, not how fast they move, so it cannot
 * tell by itself how often their poses must be renewed: a walker whose pose is half a second old slides. Speeds change
 * nothing else. What moves actors by tracks (claque/track.h) and root paths (claque/behave.h) is known and is added.
 * See clq_crowd_def.motion_tolerance_px. */
#ifndef CLAQUE_SPEED_H
#define CLAQUE_SPEED_H

#include <claque/crowd.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Says how fast the host moves actors: of all or, when it fails, of none.
 *   actors   [count]
 *   speeds   [count] world units a second, each [0, 1e9]; 0 (default): the host does not move the actor
 * Fails: STALE_ID (names the first), ARGUMENT, OUT_OF_MEMORY, BUSY. Threads: the crowd's writer. GL: none. */
CLQ_API clq_status clq_crowd_set_speeds(clq_crowd *crowd, const clq_actor *actors, const float *speeds, uint32_t count);

/* Says how fast the host moves a group. It is added to the speeds of its members.
 *   speed   [0, 1e9] world units a second of its fastest member, also while the group turns; 0 (default) where members
 *           need no more poses, such as people who sit and carry no weight on their feet
 * Fails: STALE_ID, ARGUMENT, BUSY. Threads: the crowd's writer. GL: none. */
CLQ_API clq_status clq_group_set_speed(clq_crowd *crowd, clq_group group, float speed);

#ifdef __cplusplus
}
#endif

#endif
