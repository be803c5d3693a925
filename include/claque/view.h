/* clq_view: an eye on a crowd, and the draw list that the last update made for it. Any number per crowd. */
#ifndef CLAQUE_VIEW_H
#define CLAQUE_VIEW_H

#include <claque/crowd.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef struct clq_camera {
    double eye[3];
    float rotation_xyzw[4]; /* world to eye: the eye looks along -z with y up, as GL does */
    float projection[16];   /* column-major, as glLoadMatrixf takes it; perspective or parallel */
} clq_camera;

/* Fills a camera from an eye, a point it looks at, an up direction and a symmetric perspective.
 *   fov_y_rad (0, pi)   aspect width / height   0 < z_near < z_far
 * Fails: ARGUMENT (also an up direction along the line of sight). Threads: any. */
CLQ_API clq_status clq_camera_look_at(clq_camera *camera, const double eye[3], const double target[3],
                                      const float up[3], float fov_y_rad, float aspect, float z_near, float z_far);

/* Makes a view of a crowd. out: [owner: the crowd; ends with clq_view_destroy or the crowd]
 * Fails: ARGUMENT, OUT_OF_MEMORY. Threads: the crowd's writer. GL: none. */
CLQ_API clq_status clq_view_create(clq_crowd *crowd, clq_view **out);
CLQ_API void clq_view_destroy(clq_view *view);

/* Sets the camera that the next clq_crowd_update uses. Copied. Fails: ARGUMENT (not finite, no rotation).
 * Threads: the crowd's writer. */
CLQ_API clq_status clq_view_set_camera(clq_view *view, const clq_camera *camera);

/* How high the view's picture is: levels of detail are those for distances in a picture of 768 lines over 60 degrees, and a
 * zoom lens or a larger picture gets more detail, a smaller one less (S0 5). Default 768; 0: distances as they are.
 * Fails: ARGUMENT. Threads: the crowd's writer. */
CLQ_API clq_status clq_view_set_height(clq_view *view, float height_px);

/* Culls by a pyramid that is narrower than the picture's (S0 Fig. 10), to see the culling at work: (0, 1]. Default 1.
 * Fails: ARGUMENT. Threads: the crowd's writer. */
CLQ_API clq_status clq_view_set_cull_scale(clq_view *view, float scale);

/* Shadows fall by this much, in world units: whoever's sphere swept along it meets the frustum is alive and posed, though
 * nobody but its shadow is seen; it is not drawn. Zero: there are no shadows. Default zero.
 * Fails: ARGUMENT (not finite). Threads: the crowd's writer. */
CLQ_API clq_status clq_view_set_shadow(clq_view *view, const float fall[3]);

typedef struct clq_view_stats {
    uint32_t visible;   /* individuals in the list */
    uint32_t triangles; /* of them and their levels, each triangle once; parts that phase 3 left out are not counted */
    uint32_t shadow_only;           /* of the visible: seen by nobody but their shadow */
    uint32_t parts, parts_left_out; /* of the others (S0 4.2 phase 3) */
} clq_view_stats;

/* Fails: ARGUMENT, BUSY (an update runs, or another thread draws the view). Threads: any. */
CLQ_API clq_status clq_view_get_stats(const clq_view *view, clq_view_stats *out);

/* Fingerprint of the draw list with all its matrices, colours and vertices: equal lists draw equal pictures. 0 of NULL, and
 * where clq_view_get_stats would be BUSY. Threads: any. */
CLQ_API uint64_t clq_view_hash(const clq_view *view);

#ifdef __cplusplus
}
#endif

#endif
