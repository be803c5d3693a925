/* Times of the steps of an update, for hosts that ask why a frame is slow. They are measured with the host's clock, and
 * only where the host asked for it. Nothing that a crowd shows depends on them. */
#ifndef CLAQUE_UPDATE_TIMES_H
#define CLAQUE_UPDATE_TIMES_H

#include <claque/crowd.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Measures the steps of a crowd's updates from the next one on. It costs eight calls of the clock in an update.
 *   now_s   returns seconds that never run back; it is called by the thread of clq_crowd_update. NULL (default):
 *           nothing is measured. If it throws an exception, the update's times are zero and the context's log tells
 *           of it
 *   user    passed to now_s
 * Fails: ARGUMENT, BUSY. Threads: the crowd's writer. GL: none. */
CLQ_API clq_status clq_crowd_set_step_clock(clq_crowd *crowd, double (*now_s)(void *user), void *user);

/* Seconds of the steps of the last update, in their order (S0 4.2, S1 4). */
typedef struct clq_update_times {
    uint32_t struct_bytes; /* set by clq_update_times_init */
    bool measured;         /* false: all are zero */
    double cull_s;         /* groups, tracks, Reference Points and Skeleton Roots, with the first two cull phases */
    double choose_s;       /* levels, update rates, and which poses are due */
    double behave_s;       /* control mechanisms */
    double animate_s;      /* matrix palettes of the poses that are due */
    double cull_parts_s;   /* the third cull phase, by Internal Bspheres */
    double skin_s;         /* vertices of the poses that are due */
    double list_s;         /* the draw lists of all views */
} clq_update_times;

CLQ_DEFINE_ZERO_INIT(clq_update_times)

/* Gets the times of a crowd's last update.
 *   out   made by clq_update_times_init
 * Fails: STRUCT_SIZE, ARGUMENT, BUSY. Threads: any. GL: none. */
CLQ_API clq_status clq_crowd_get_update_times(const clq_crowd *crowd, clq_update_times *out);

#ifdef __cplusplus
}
#endif

#endif
