/* The split meshes of a template as numbers (S1 3), for renderers of the host's own and for tests of such renderers
 * against claque (docs/parity.md). All arrays belong to the template and live as long as it does. */
#ifndef CLAQUE_MESH_H
#define CLAQUE_MESH_H

#include <claque/template.h>

#ifdef __cplusplus
extern "C" {
#endif

/* The mesh of one level of detail. */
typedef struct clq_mesh {
    uint32_t struct_bytes;    /* set by clq_mesh_init */
    uint32_t vertex_count;    /* vertices that are skinned, without the copies of the fused strategy */
    const float *positions;   /* [3 * vertex_count] in the bind pose */
    const float *normals;     /* [3 * vertex_count] of length 1 */
    const float *uvs;         /* [2 * vertex_count] */
    const uint8_t *colours;   /* [4 * vertex_count] factors of the zone's colour; NULL: white */
    uint32_t influence_count; /* the largest number of influences of a vertex */
    uint32_t bin_count;       /* bins of triangles, see clq_template_get_triangles */
    uint32_t morph_count;     /* morph targets */
    /* True: palette matrices may stretch. A normal then follows the blended inverse transposes of the matrices, each
     * scaled to the size of a rotation. False: a normal follows the blended matrix itself. */
    bool normals_by_inverse;
} clq_mesh;

/* A bin: triangles of one texture, one sidedness, one lighting, and one zone or several. The bins of a mesh contain
 * each triangle once, in the order of drawing. */
typedef struct clq_triangles {
    uint32_t struct_bytes; /* set by clq_triangles_init */
    uint32_t texture;      /* of the template, see clq_template_get_texture */
    bool double_sided;
    uint32_t zone; /* clean triangles: the zone of all their pixels. CLQ_NONE: dirty triangles */
    uint32_t index_count;
    const uint32_t *indices; /* [index_count], three per triangle, counter-clockwise seen from the front */
    bool unlit;              /* true: drawn without GL_LIGHTING */
    float emission[3];       /* GL_EMISSION; the texture multiplies it as it multiplies light */
} clq_triangles;

/* An addend to one vertex before skinning, times the target's weight. */
typedef struct clq_morph_delta {
    uint32_t vertex;
    float position[3], normal[3];
} clq_morph_delta;

typedef struct clq_morph_target {
    uint32_t struct_bytes; /* set by clq_morph_target_init */
    uint32_t weight;       /* index of its weight among those of clq_view_get_morph_weights */
    uint32_t delta_count;
    const clq_morph_delta *deltas; /* [delta_count] */
} clq_morph_target;

/* The host's arrays for the influences of all vertices of a level. */
typedef struct clq_influences {
    uint32_t struct_bytes; /* set by clq_influences_init */
    uint32_t per_vertex;   /* entries for each vertex; clq_mesh.influence_count or more */
    uint16_t *joints;      /* [capacity], written: indices of clq_template_def.joints, the heaviest first */
    float *weights;        /* [capacity], written: the sum of each vertex is 1 */
    size_t capacity;       /* entries in each array; per_vertex * vertex_count or more */
} clq_influences;

CLQ_DEFINE_ZERO_INIT(clq_mesh)
CLQ_DEFINE_ZERO_INIT(clq_triangles)
CLQ_DEFINE_ZERO_INIT(clq_morph_target)
CLQ_DEFINE_ZERO_INIT(clq_influences)

/* Get a level's mesh, one of its bins, or one of its morph targets.
 *   out   made by its _init function
 * Fail: STRUCT_SIZE, ARGUMENT (NULL, an index that is too large). Threads: any. GL: none. S2 2.5. */
CLQ_API clq_status clq_template_get_mesh(const clq_template *tmpl, uint32_t level, clq_mesh *out);
CLQ_API clq_status clq_template_get_triangles(const clq_template *tmpl, uint32_t level, uint32_t bin,
                                              clq_triangles *out);
CLQ_API clq_status clq_template_get_morph_target(const clq_template *tmpl, uint32_t level, uint32_t target,
                                                 clq_morph_target *out);

/* Copies the influences of a level's vertices. Unused entries of a vertex have joint 0 and weight 0.
 *   out   made by clq_influences_init; the host then sets all members, and the call fills the arrays
 * Fails: STRUCT_SIZE, ARGUMENT (also per_vertex or a capacity that is too small). Threads: any. GL: none. */
CLQ_API clq_status clq_template_get_influences(const clq_template *tmpl, uint32_t level, const clq_influences *out);

/* Gets how a texture continues beyond its sides: CLQ_WRAP_REPEAT or CLQ_WRAP_CLAMP. Mirrored textures contain their
 * mirror images, so CLQ_WRAP_MIRROR does not occur.
 * Fails: ARGUMENT. Threads: any. GL: none. */
CLQ_API clq_status clq_template_get_wrap(const clq_template *tmpl, uint32_t texture, clq_wrap *out_s, clq_wrap *out_t);

#ifdef __cplusplus
}
#endif

#endif
