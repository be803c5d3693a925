/* The split meshes of a template as numbers (S1 3): for renderers of a host's own, and for those who test theirs against
 * claque (docs/parity.md). All arrays are the template's and live as long as it does. */
#ifndef CLAQUE_MESH_H
#define CLAQUE_MESH_H

#include <claque/template.h>

#ifdef __cplusplus
extern "C" {
#endif

/* One level of detail. */
typedef struct clq_mesh {
    uint32_t vertex_count;      /* that are skinned; copies that the fused strategy adds are not among them */
    const float *positions;     /* [3 * vertex_count] bind pose */
    const float *normals;       /* [3 * vertex_count] unit */
    const float *uvs;           /* [2 * vertex_count] */
    const uint8_t *colours;     /* [4 * vertex_count] multiply the zone's colour; NULL: white */
    uint32_t influence_count;   /* the most that a vertex has */
    uint32_t bin_count;         /* of triangles, see clq_template_get_triangles */
    uint32_t morph_count;       /* targets */
    int32_t normals_by_inverse; /* 1: palette matrices may stretch, and a normal follows their inverse transposes, each
                                   to the size of a rotation, blended; 0: the blended matrix itself */
} clq_mesh;

/* Triangles of one texture, one sidedness, and one zone or several. A mesh's are all its bins, in the order in which they are
 * drawn; each triangle stands in one. */
typedef struct clq_triangles {
    uint32_t texture; /* of the template, see clq_template_get_texture */
    int32_t double_sided;
    uint32_t zone; /* that all their pixels show (clean); CLQ_NONE: each may show several (dirty) */
    uint32_t index_count;
    const uint32_t *indices; /* [index_count], three a triangle, counter-clockwise seen from the front */
} clq_triangles;

typedef struct clq_morph_delta {
    uint32_t vertex;
    float position[3], normal[3]; /* times the weight, added before skinning */
} clq_morph_delta;

typedef struct clq_morph_target {
    uint32_t weight; /* of clq_view_get_pose: by which number it is weighed */
    uint32_t delta_count;
    const clq_morph_delta *deltas;
} clq_morph_target;

/* Fail: ARGUMENT. Threads: any. GL: none. Seed: S2 2.5. */
CLQ_API clq_status clq_template_get_mesh(const clq_template *tmpl, uint32_t level, clq_mesh *out);
CLQ_API clq_status clq_template_get_triangles(const clq_template *tmpl, uint32_t level, uint32_t bin,
                                              clq_triangles *out);
CLQ_API clq_status clq_template_get_morph_target(const clq_template *tmpl, uint32_t level, uint32_t target,
                                                 clq_morph_target *out);

/* What each vertex of a level follows: entries of clq_template_def.joints, the heaviest first, and weights that sum to 1.
 *   per_vertex    at least clq_mesh.influence_count; places that a vertex does not need get joint 0 and weight 0
 *   out_joints, out_weights   [per_vertex * vertex_count]
 *   capacity      places in each
 * Fails: ARGUMENT. Threads: any. GL: none. */
CLQ_API clq_status clq_template_get_influences(const clq_template *tmpl, uint32_t level, uint32_t per_vertex,
                                               uint16_t *out_joints, float *out_weights, size_t capacity);

/* How a texture continues beyond its sides: CLQ_WRAP_REPEAT or CLQ_WRAP_CLAMP (mirrors are in the texels).
 * Fails: ARGUMENT. Threads: any. GL: none. */
CLQ_API clq_status clq_template_get_wrap(const clq_template *tmpl, uint32_t texture, clq_wrap *out_s, clq_wrap *out_t);

#ifdef __cplusplus
}
#endif

#endif
