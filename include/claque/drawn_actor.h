/* What a view shows, individual by individual, as numbers: for renderers of a host's own, and for those who test theirs
 * against claque (docs/parity.md). Of the last update in which the view took part.
 *
 * All here fail with ARGUMENT (an index that is not in the list, room for too little, with the numbers) and BUSY (an
 * update runs, or another thread draws the view). Threads: any, one at a time for a view. GL: none. */
#ifndef CLAQUE_SHOWN_H
#define CLAQUE_SHOWN_H

#include <claque/view.h>

#ifdef __cplusplus
extern "C" {
#endif

/* One individual of the draw list: `visible` of clq_view_stats of them, in the order in which they are drawn. */
typedef struct clq_drawn_actor {
    clq_actor actor;
    const clq_template *tmpl;
    uint32_t level;       /* of detail */
    uint32_t texture_set; /* of the template, see clq_template_get_set_texture */
    float model_view[16]; /* column-major: from the actor's own space to eye space */
    float eye_distance_m;
    int32_t mirrored;    /* 1: front faces wind clockwise */
    int32_t shadow_only; /* 1: seen by nobody but its shadow; it is not drawn */
    uint64_t parts;      /* bit k: part k of the level is in view and drawn (S0 4.2 phase 3) */
    uint32_t vertex_count, joint_count, morph_weight_count, zone_count; /* what the calls below want room for */
} clq_drawn_actor;

CLQ_API clq_status clq_view_get_drawn_actor(const clq_view *view, uint32_t index, clq_drawn_actor *out);

/* Its colours, one RGB a zone of its template, as the renderer gives them to GL.
 *   out_rgb   [3 * capacity_zones], at least zone_count */
CLQ_API clq_status clq_view_get_colours(const clq_view *view, uint32_t index, uint8_t *out_rgb,
                                        uint32_t capacity_zones);

/* Its skinned vertices, as the renderer draws them, in its own space: those of clq_mesh, in that order. Packed ones are
 * unpacked; normals have the length that skinning leaves. Who is in no cache is skinned for it.
 *   out_positions, out_normals   [3 * capacity_vertices], at least vertex_count; either may be NULL
 * Also OUT_OF_MEMORY. */
CLQ_API clq_status clq_view_get_vertices(const clq_view *view, uint32_t index, float *out_positions, float *out_normals,
                                         uint32_t capacity_vertices);

/* Its matrix palette (S1 4) and morph weights: what those vertices are skinned from.
 *   out_palette   [12 * capacity_joints], at least joint_count: one matrix an entry of clq_template_def.joints, the node's
 *                 times the inverse bind matrix, in the actor's own space; three columns of axes and one of the
 *                 translation. Entries that its level of detail does not use are the identity
 *   out_weights   [capacity_weights], at least morph_weight_count; NULL: not asked for
 * Also ARGUMENT of who shows a blend of two key-poses (CLQ_KEY_POSE_INTERPOLATED), which has vertices but no palette. */
CLQ_API clq_status clq_view_get_pose(const clq_view *view, uint32_t index, float *out_palette, uint32_t capacity_joints,
                                     float *out_weights, uint32_t capacity_weights);

#ifdef __cplusplus
}
#endif

#endif
