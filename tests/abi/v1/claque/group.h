/* clq_group: actors that are tested and moved together, such as a vehicle with its occupants, a flock, or a block of
 * seats (S0 4.3, 8).
 *
 * A group is a space: the transforms of its members are relative to it. The Group Bsphere, which holds all members, is
 * tested before their own spheres. Members of a group that no view meets, or that is disabled, cost an update nothing.
 * The host's scene graph may cull a group and disable it. Groups do not nest. */
#ifndef CLAQUE_GROUP_H
#define CLAQUE_GROUP_H

#include <claque/crowd.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Creates an enabled group without members.
 *   transform   of the group in the world, with a scale of either sign within [1e-6, 1e6]; NULL: the world's own space
 * Fails: ARGUMENT, LIMIT, OUT_OF_MEMORY, BUSY. Threads: the crowd's writer. GL: none. */
CLQ_API clq_status clq_group_create(clq_crowd *crowd, const clq_transform *transform, clq_group *out);

/* Destroys a group. Its members keep their place in the world, within rounding. A member whose world position overflows
 * keeps its local one. The call visits every actor.
 * Fails: STALE_ID, BUSY. Threads: the crowd's writer. GL: none. */
CLQ_API clq_status clq_group_destroy(clq_crowd *crowd, clq_group group);

/* Moves a group with all its members, at a cost that does not depend on their number.
 * Fails: STALE_ID, ARGUMENT, BUSY. Threads: the crowd's writer. GL: none. */
CLQ_API clq_status clq_group_set_transform(clq_crowd *crowd, clq_group group, const clq_transform *transform);

/* Enables or disables a group. Members of a disabled group are not seen and cost nothing; the clocks of their clips go
 * on. Fails: STALE_ID, BUSY. Threads: the crowd's writer. GL: none. */
CLQ_API clq_status clq_group_set_enabled(clq_crowd *crowd, clq_group group, bool enabled);

/* Makes an actor a member of a group, in place of the group it was in. Its transforms are then in the group's space.
 *   group       {0, 0}: the actor leaves its group
 *   transform   in the space of the new group (or the world); NULL: the actor keeps its place in the world
 * Fails: STALE_ID, ARGUMENT, OUT_OF_MEMORY, BUSY. Threads: the crowd's writer. GL: none. */
CLQ_API clq_status clq_actor_join(clq_crowd *crowd, clq_actor actor, clq_group group, const clq_transform *transform);

typedef struct clq_group_info {
    uint32_t struct_bytes; /* set by clq_group_info_init */
    clq_transform transform;
    uint32_t member_count;
    bool enabled;
    bool visible; /* enabled, and a view of the last update met its sphere */
} clq_group_info;

CLQ_DEFINE_ZERO_INIT(clq_group_info)

/* Gets the state of a group.
 *   out   made by clq_group_info_init
 * Fails: STRUCT_SIZE, STALE_ID, ARGUMENT, BUSY. Threads: any. GL: none. */
CLQ_API clq_status clq_group_get_info(const clq_crowd *crowd, clq_group group, clq_group_info *out);

#ifdef __cplusplus
}
#endif

#endif
