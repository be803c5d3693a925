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
CLQ_API clq_status clq_view_look(clq_view *view, const clq_camera *camera);

typedef struct clq_view_stats {
    uint32_t visible;   /* individuals in the list */
    uint32_t triangles; /* of them, each triangle once */
} clq_view_stats;

CLQ_API clq_status clq_view_get_stats(const clq_view *view, clq_view_stats *out);

/* Fingerprint of the draw list with all its matrices, colours and vertices: equal lists draw equal pictures. */
CLQ_API uint64_t clq_view_hash(const clq_view *view);

#ifdef __cplusplus
}
#endif

#endif
