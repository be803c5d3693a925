/* The draw list of a view as numbers, individual by individual, for renderers of the host's own and for tests of such
 * renderers against claque (docs/parity.md). It is that of the last update in which the view took part.
 *
 * All calls here fail with ARGUMENT (NULL; an index beyond the list; a capacity that is too small, with the numbers)
 * and BUSY (an update runs, or another thread draws or reads the view). Threads: any, one at a time for a view. GL:
 * none. */
#ifndef CLAQUE_DRAWN_ACTOR_H
#define CLAQUE_DRAWN_ACTOR_H

#include <claque/view.h>

#ifdef __cplusplus
extern "C" {
#endif

/* An individual of the draw list. The list has clq_view_stats.visible of them, in the order of drawing. */
typedef struct clq_drawn_actor {
    uint32_t struct_bytes; /* set by clq_drawn_actor_init */
    clq_actor actor;
    const clq_template *tmpl;
    uint32_t level;       /* of detail */
    uint32_t texture_set; /* of the template, see clq_template_get_texture */
    float model_view[16]; /* from model space to eye space */
    float eye_distance_m;
    bool mirrored;    /* front faces wind clockwise */
    bool shadow_only; /* only its shadow is in view: the individual is not drawn */
    uint64_t parts;   /* bit k: part k of the level is in view and drawn (S0 4.2, phase 3) */
    uint32_t vertex_count, joint_count, morph_weight_count, zone_count; /* the capacities that the calls below need */
} clq_drawn_actor;

CLQ_DEFINE_ZERO_INIT(clq_drawn_actor)

/* Arrays of an individual in the library's own memory, in the layouts of the calls below that copy. NULL: the draw list
 * does not hold the array, and the call that copies computes it. */
typedef struct clq_drawn_arrays {
    uint32_t struct_bytes;            /* set by clq_drawn_arrays_init */
    const float *positions, *normals; /* [3 * vertex_count]; NULL: packed, placed by GL's matrix stack, or left out */
    /* [4 * vertex_count] of a crowd of CLQ_VERTEX_PACKED: the first three of four are n and mean
     * packed_offset + packed_step * n, and n / 127 for a normal */
    const int16_t *packed_positions;
    const int8_t *packed_normals;
    float packed_offset[3], packed_step;
    const float *palette;       /* [12 * joint_count]; NULL also where the level has deactivated nodes */
    const float *morph_weights; /* [morph_weight_count] */
    const uint8_t *colours;     /* [3 * zone_count]; NULL: the template's own colours */
} clq_drawn_arrays;

CLQ_DEFINE_ZERO_INIT(clq_drawn_arrays)

/* Gets an individual.
 *   index   [0, clq_view_stats.visible)
 *   out     made by clq_drawn_actor_init
 * Fails also: STRUCT_SIZE. */
CLQ_API clq_status clq_view_get_drawn_actor(const clq_view *view, uint32_t index, clq_drawn_actor *out);

/* Gets the arrays of an individual without copying them.
 *   index   [0, clq_view_stats.visible)
 *   out     made by clq_drawn_arrays_init. The arrays belong to the crowd. They are valid and unchanged until the next
 *           clq_crowd_update or clq_crowd_restore of the crowd, whichever its views, or the end of the view or of the
 *           crowd; reading them later is undefined. Other calls leave them as they are
 * Fails also: STRUCT_SIZE. Threads: the arrays may be read by any number of threads. */
CLQ_API clq_status clq_view_get_arrays(const clq_view *view, uint32_t index, clq_drawn_arrays *out);

/* Gets the colours of an individual as the renderer passes them to GL.
 *   out_rgb          [3 * capacity_zones], one RGB per zone of the template
 *   capacity_zones   zone_count or more */
CLQ_API clq_status clq_view_get_colours(const clq_view *view, uint32_t index, uint8_t *out_rgb,
                                        uint32_t capacity_zones);

/* Gets the skinned vertices of an individual as the renderer draws them, in model space, in the order of clq_mesh.
 * Packed vertices are unpacked. Normals have the length that skinning gives them. Parts that GL's matrix stack places
 * are skinned for the call.
 *   out_positions, out_normals   [3 * capacity_vertices]; either may be NULL
 *   capacity_vertices            vertex_count or more
 * Fails also: OUT_OF_MEMORY, also for an individual that the update left out. */
CLQ_API clq_status clq_view_get_vertices(const clq_view *view, uint32_t index, float *out_positions, float *out_normals,
                                         uint32_t capacity_vertices);

/* Gets the matrix palette of an individual (S1 4), from which its vertices are skinned.
 *   out_palette       [12 * capacity_joints]: for each entry of clq_template_def.joints the node's matrix times the
 *                     inverse bind matrix, in model space, as three columns of axes and one of the translation. Entries
 *                     that the level does not use are the identity
 *   capacity_joints   joint_count or more
 * Fails also: ARGUMENT for a blend of two key-poses (CLQ_KEY_POSE_INTERPOLATED), which has vertices but no palette;
 * OUT_OF_MEMORY. */
CLQ_API clq_status clq_view_get_palette(const clq_view *view, uint32_t index, float *out_palette,
                                        uint32_t capacity_joints);

/* Gets the morph weights of an individual, from which its vertices are skinned.
 *   out_weights        [capacity_weights]
 *   capacity_weights   morph_weight_count or more
 * Fails also: as clq_view_get_palette. */
CLQ_API clq_status clq_view_get_morph_weights(const clq_view *view, uint32_t index, float *out_weights,
                                              uint32_t capacity_weights);

#ifdef __cplusplus
}
#endif

#endif
