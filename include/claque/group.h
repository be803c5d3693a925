/* clq_group: actors that are tested and moved together: a vehicle with its occupants, a flock, a block of seats.
 *
 * A group is a space: its members' places are given in it, and go where it goes. The sphere round all of them (Group
 * Bsphere, S0 4.3) is tested before theirs: the members of a group that no view meets, or that is disabled, cost an
 * update nothing. A host's scenegraph may cull a group itself, and disable it. Groups do not nest. */
#ifndef CLAQUE_GROUP_H
#define CLAQUE_GROUP_H

#include <claque/crowd.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Makes a group without members, enabled.
 *   place   of its space in the world; NULL: the world's own. Scale within [1e-6, 1e6] either sign
 * Fails: ARGUMENT, LIMIT, OUT_OF_MEMORY. Threads: the crowd's writer. GL: none. */
CLQ_API clq_status clq_group_create(clq_crowd *crowd, const clq_transform *transform, clq_group *out);

/* Ends a group. Its members stay where they are in the world, within rounding; one whose place there is beyond what
 * numbers hold keeps those of its place in the group. Costs a look at every actor.
 * Fails: STALE_ID. Threads: the crowd's writer. */
CLQ_API clq_status clq_group_destroy(clq_crowd *crowd, clq_group group);

/* Moves a group with all its members; costs the same for any number of them.
 * Fails: STALE_ID, ARGUMENT. Threads: the crowd's writer. */
CLQ_API clq_status clq_group_set_transform(clq_crowd *crowd, clq_group group, const clq_transform *transform);

/* Switches a group off (0) or on: nobody of a group that is off is seen, or costs anything; their clips' clocks go on.
 * Fails: STALE_ID. Threads: the crowd's writer. */
CLQ_API clq_status clq_group_enable(clq_crowd *crowd, clq_group group, int32_t enabled);

/* Makes an actor a member, in place of any group it was in. From then on clq_crowd_set_transforms places it in the group's space.
 *   group   {0, 0}: it leaves its group
 *   place   in the group's space (or the world's, where it leaves); NULL: it stays where it is in the world
 * Fails: STALE_ID, ARGUMENT. Threads: the crowd's writer. */
CLQ_API clq_status clq_actor_join(clq_crowd *crowd, clq_actor actor, clq_group group, const clq_transform *transform);

typedef struct clq_group_info {
    clq_transform transform;
    uint32_t member_count;
    int32_t enabled;
    int32_t visible; /* 1: enabled, and a view of the last update met its sphere */
} clq_group_info;

/* Fails: STALE_ID, ARGUMENT. Threads: any, not during an update. */
CLQ_API clq_status clq_group_get_info(const clq_crowd *crowd, clq_group group, clq_group_info *out);

#ifdef __cplusplus
}
#endif

#endif
