/* clq_view: a camera on a crowd, with the draw list that the last update made for it. A crowd may have any number of
 * views. */
#ifndef CLAQUE_VIEW_H
#define CLAQUE_VIEW_H

#include <claque/crowd.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef struct clq_camera {
    double eye[3]; /* in the world */
    /* From the world to eye space, in which the eye looks along -z with y up, as in GL. Of length 1 within 0.001. */
    float rotation_xyzw[4];
    float projection[16]; /* as glLoadMatrixf takes it; perspective or parallel */
} clq_camera;

/* A camera described by an eye, the point that it looks at, and a symmetric perspective. */
typedef struct clq_look_at_def {
    uint32_t struct_bytes;    /* set by clq_look_at_def_init */
    double eye[3], target[3]; /* in the world; different points */
    float up[3];              /* not along the line of sight. Default 0, 1, 0 */
    float fov_y_rad;          /* (0, pi) vertical field of view. Default 60 degrees */
    float aspect;             /* (> 0) width / height of the picture. Default 4 / 3 */
    float z_near, z_far;      /* 0 < z_near < z_far, in world units. Default 0.1 and 1000 */
} clq_look_at_def;

/* Returns a camera at the origin that looks along -z. */
static inline clq_look_at_def clq_look_at_def_init(void)
{
    clq_look_at_def def;
    memset(&def, 0, sizeof def);
    def.struct_bytes = (uint32_t)sizeof def;
    def.target[2] = -1.0;
    def.up[1] = 1.0f;
    def.fov_y_rad = 1.0471976f;
    def.aspect = 4.0f / 3.0f;
    def.z_near = 0.1f;
    def.z_far = 1000.0f;
    return def;
}

/* Computes a camera.
 * Fails: STRUCT_SIZE, ARGUMENT (a number out of its range). Threads: any. GL: none. */
CLQ_API clq_status clq_camera_look_at(const clq_look_at_def *def, clq_camera *out);

/* Creates a view of a crowd.
 *   out   owned by the crowd; ends with clq_view_destroy or with the crowd
 * Fails: ARGUMENT, OUT_OF_MEMORY, BUSY. Threads: the crowd's writer. GL: none. */
CLQ_API clq_status clq_view_create(clq_crowd *crowd, clq_view **out);

/* Destroys a view; NULL is ignored. Fails: BUSY; the view then stays. Threads: the crowd's writer. GL: none. */
CLQ_API clq_status clq_view_destroy(clq_view *view);

/* Sets the camera for the next clq_crowd_update. Copied.
 * Fails: ARGUMENT (a number that is not finite, a rotation that is not of length 1), BUSY.
 * Threads: the crowd's writer. GL: none. */
CLQ_API clq_status clq_view_set_camera(clq_view *view, const clq_camera *camera);

/* Sets the height of the view's picture. Levels of detail are made for a picture of 768 lines over 60 degrees. A larger
 * picture or a narrower field of view gets more detail, a smaller one less (S0 5).
 *   height_px   [>= 0] default 768; 0: the view does not scale distances
 * Fails: ARGUMENT, BUSY. Threads: the crowd's writer. GL: none. */
CLQ_API clq_status clq_view_set_height(clq_view *view, float height_px);

/* Culls by a pyramid that is narrower than the picture's, to show the culling at work (S0 Fig. 10).
 *   scale   (0, 1] default 1
 * Fails: ARGUMENT, BUSY. Threads: the crowd's writer. GL: none. */
CLQ_API clq_status clq_view_set_cull_scale(clq_view *view, float scale);

/* Culls by the part of the picture that is drawn, for a picture whose parts are drawn by several processes or GL
 * contexts: each draws with the whole picture's camera and viewport, and limits GL to its own part (glScissor). Levels
 * of detail, ticks, poses and the order of the draw list are those of the whole picture, so that the parts together are
 * the picture that one view draws. Two exceptions: lod_hysteresis (clq_crowd_def) remembers what this view had in its
 * own part, and CLQ_CLOCK_LIVE shares its budget among what is in it.
 *   tile   left, bottom, right, top as shares of the picture's width and height from its lower left corner;
 *          0 <= left < right <= 1, 0 <= bottom < top <= 1. Copied. Default 0, 0, 1, 1: the whole picture. With
 *          clq_view_set_cull_scale what both contain is in view
 * Fails: ARGUMENT, BUSY. Threads: the crowd's writer. GL: none. */
CLQ_API clq_status clq_view_set_tile(clq_view *view, const float tile[4]);

/* Sets the vector by which shadows fall, in world units. Actors whose bounding sphere, swept by this vector, meets the
 * frustum are updated as shadow casters but not drawn. Default zero: there are no shadows.
 * Fails: ARGUMENT (not finite), BUSY. Threads: the crowd's writer. GL: none. */
CLQ_API clq_status clq_view_set_shadow(clq_view *view, const float fall[3]);

typedef struct clq_view_stats {
    uint32_t struct_bytes;          /* set by clq_view_stats_init */
    uint32_t visible;               /* individuals in the draw list */
    uint32_t triangles;             /* triangles of their levels, each once, without parts that phase 3 left out */
    uint32_t shadow_only;           /* of the visible, individuals of which only the shadow is in view */
    uint32_t parts, parts_left_out; /* parts of the others that are drawn, and that phase 3 left out (S0 4.2) */
    uint64_t bytes;                 /* memory that the draw list holds */
} clq_view_stats;

CLQ_DEFINE_ZERO_INIT(clq_view_stats)

/* Gets the counts of a view's draw list.
 *   out   made by clq_view_stats_init
 * Fails: STRUCT_SIZE, ARGUMENT, BUSY (an update runs, or another thread draws or reads the view). Threads: any. GL:
 * none. */
CLQ_API clq_status clq_view_get_stats(const clq_view *view, clq_view_stats *out);

/* Returns a hash of the draw list with all its matrices, colours and vertices: equal lists draw equal pictures. 0 for
 * NULL and where clq_view_get_stats would be BUSY. Threads: any. GL: none. */
CLQ_API uint64_t clq_view_get_hash(const clq_view *view);

/* An actor that entered or left view. */
typedef struct clq_view_change {
    clq_actor actor;
    bool in_view; /* a view of the last update sees it, as clq_actor_info.visible says */
} clq_view_change;

/* Gets the actors that entered or left view in the last clq_crowd_update, in the order of index1: each that a view of
 * this update sees and no view of the update before saw, or the other way round. The first update after an actor's
 * creation tells of it, whether it is in view or not; so does the first after clq_crowd_restore, of all. Actors
 * destroyed since are left out. An update that failed changes nothing. claque remembers of each actor whether the last
 * two updates saw it (5 bytes); what is drawn never depends on it. The call's time grows with the number of actors that
 * changed and, in steps of 64 actors, of those in view.
 *   out         [capacity], or NULL with capacity 0: the call only counts
 *   out_count   the number of actors
 * Fails: ARGUMENT, LIMIT (more than capacity; nothing is written then), BUSY. Threads: any. GL: none. */
CLQ_API clq_status clq_crowd_get_view_changes(const clq_crowd *crowd, clq_view_change *out, size_t capacity,
                                              size_t *out_count);

#ifdef __cplusplus
}
#endif

#endif
