/* clq_template: a character that many individuals share: its nodes, clips, zones, and meshes split into clean and dirty
 * triangles (S1 3). Immutable once made, so any number of threads may read it. Made from a host's own arrays here, from
 * a prepared file here, or from glTF and the built-in figures in claque/assets.h.
 *
 * Space: right-handed, any up axis; model space is the actor's own space, in which the Reference Point is the origin.
 */
#ifndef CLAQUE_TEMPLATE_H
#define CLAQUE_TEMPLATE_H

#include <claque/context.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef struct clq_template clq_template;

#define CLQ_NONE 0xffffffffu /* no index */

/* One node of the articulated structure (S0 3). Parents stand before their children. */
typedef struct clq_node_def {
    const char *name; /* may be NULL */
    uint32_t parent;  /* index of an earlier node, or CLQ_NONE */
    float translation[3];
    float rotation_xyzw[4]; /* unit within 0.001; all zero means no rotation */
    float scale[3];         /* all zero means 1, 1, 1 */
    /* S0 5.2: [metres] from this distance on the node and all below it are not evaluated. Rigid parts on them must have
     * ended there, and one on a node that is left must begin there; the weights of skinned vertices go to the nearest
     * node that is left. 0: never. */
    float deactivation_m;
} clq_node_def;

typedef enum clq_dof_kind {
    CLQ_DOF_ROTATION = 0,    /* a turn about axis, radians */
    CLQ_DOF_TRANSLATION = 1, /* a shift along axis, model units */
    CLQ_DOF_MORPH = 2        /* added to the weight of a morph target of the node's parts */
} clq_dof_kind;

/* A degree of freedom of a node (S0 3): a number that control mechanisms write, see claque/behave.h. It acts between the
 * node's rotation and its scale, on top of the clip, in the order of the list. */
typedef struct clq_dof_def {
    const char *name; /* may be NULL */
    uint32_t node;
    clq_dof_kind kind;
    uint32_t morph_target; /* CLQ_DOF_MORPH: which one */
    float axis[3];         /* unit within 0.001, in the node's own frame; unused for CLQ_DOF_MORPH */
    float min, max;        /* its range: first <= last */
    float rest;            /* within the range: where it is when nobody writes it */
} clq_dof_def;

/* A matrix that vertices may follow: the node's, times inverse_bind (column-major, 16 floats; NULL: identity). */
typedef struct clq_joint_def {
    uint32_t node;
    const float *inverse_bind;
} clq_joint_def;

typedef enum clq_wrap { CLQ_WRAP_REPEAT = 0, CLQ_WRAP_CLAMP = 1, CLQ_WRAP_MIRROR = 2 } clq_wrap;

/* What the alpha of an image means (SPEC: keys are keys only where somebody says so). */
typedef enum clq_alpha_meaning { CLQ_ALPHA_OPACITY = 0, CLQ_ALPHA_ZONE_KEYS = 1 } clq_alpha_meaning;

typedef enum clq_alpha_mode { CLQ_ALPHA_OPAQUE = 0, CLQ_ALPHA_MASK = 1 } clq_alpha_mode;

typedef struct clq_image_def {
    const char *name;
    uint32_t width_px, height_px; /* [1, 16384] */
    const uint8_t *rgba;          /* [4 * width_px * height_px], the row at v = 0 first */
    clq_alpha_meaning alpha;
} clq_image_def;

/* Where an individual's colour of one zone may lie (S2 5). Degrees and fractions; a hue range wraps when first > last.
 */
typedef struct clq_hsb_range {
    float hue_min_deg, hue_max_deg;       /* [0, 360] */
    float saturation_min, saturation_max; /* [0, 1] */
    float brightness_min, brightness_max; /* [0, 1] */
} clq_hsb_range;

/* A region that has one colour per individual. */
typedef struct clq_zone_def {
    const char *name;
    uint32_t key;        /* [0, 255] the alpha that means this zone, in images whose alpha holds zone keys */
    float colour[3];     /* [0, 1] colour of an individual that was given none, as glColor takes it */
    clq_hsb_range range; /* what clq_actor_randomise_colours draws from */
} clq_zone_def;

typedef struct clq_material_def {
    const char *name;
    float base_colour[4]; /* as glColor takes it; all zero means white */
    uint32_t image;       /* CLQ_NONE: none */
    clq_wrap wrap_s, wrap_t;
    clq_alpha_mode alpha_mode; /* MASK: texels below alpha_cutoff are holes (images whose alpha is opacity) */
    float alpha_cutoff;
    int32_t double_sided; /* 0 or 1 */
    uint32_t zone;        /* zone of all that is drawn with it; CLQ_NONE where its image holds zone keys */
} clq_material_def;

/* Other images for the same surfaces, for individuals that differ in more than colours (S1 1, S2 2.1). The first set, 0, is
 * the materials' own; these are 1, 2, ... Whatever a set shows, a triangle is clean where one zone is all that any set can
 * show there: sets whose zones lie alike cost nothing but their texels. */
typedef struct clq_texture_set_def {
    const char *name;
    const uint32_t
        *images; /* [material_count] shown in place of each material's own, which it must have, and whose alpha
                               means the same; of any size; CLQ_NONE: its own */
} clq_texture_set_def;

/* Deltas of one morph target; each [3 * vertex_count] or NULL. */
typedef struct clq_morph_def {
    const float *positions;
    const float *normals;
    float rest_weight; /* parts on one node share their weights: the first part's are taken */
} clq_morph_def;

/* A triangle mesh. Skinned: joints and weights; rigid: hangs on `node` and has neither. */
typedef struct clq_part_def {
    const char *name;
    uint32_t node; /* rigid: what it hangs on. Skinned with morph targets: the node that clips address the weights by */
    uint32_t material; /* CLQ_NONE: white, one-sided */
    uint32_t vertex_count;
    const float *positions;   /* [3 * vertex_count] */
    const float *normals;     /* [3 * vertex_count] or NULL: flat */
    const float *uvs;         /* [2 * vertex_count] or NULL */
    const uint8_t *colours;   /* [4 * vertex_count] as GL takes them, or NULL */
    uint32_t influence_count; /* a vertex; 0: rigid */
    const uint32_t *joints;   /* [influence_count * vertex_count] entries of clq_template_def.joints */
    const float *weights;     /* the same length; each vertex's sum is 1 within 0.001 */
    uint32_t index_count;     /* three a triangle; 0: vertices in order */
    const uint32_t *indices;
    uint32_t morph_count;
    const clq_morph_def *morphs;
    /* S0 5.1: [metres] the distances from the eye at which this part is drawn, first <= d < last. Levels of detail of one
     * piece are several parts with adjoining ranges; each piece may have its own. last 0: no end. */
    float lod_min_m, lod_max_m;
} clq_part_def;

typedef enum clq_channel_target {
    CLQ_CHANNEL_TRANSLATION = 0,
    CLQ_CHANNEL_ROTATION = 1,
    CLQ_CHANNEL_SCALE = 2,
    CLQ_CHANNEL_MORPH_WEIGHTS = 3
} clq_channel_target;
typedef enum clq_interpolation {
    CLQ_INTERPOLATION_STEP = 0,
    CLQ_INTERPOLATION_LINEAR = 1,
    CLQ_INTERPOLATION_CUBIC_SPLINE = 2
} clq_interpolation;

/* One animated property of one node, as glTF 2.0 has them: cubic splines hold in-tangent, value, out-tangent per key.
 * Morph weights are addressed by the node of the part; all parts on one node share them. */
typedef struct clq_channel_def {
    uint32_t node;
    clq_channel_target target;
    clq_interpolation interpolation;
    uint32_t key_count;   /* [>= 1] */
    const float *times_s; /* [key_count], strictly ascending */
    const float *values;  /* [key_count * components * (3 for cubic splines)] */
} clq_channel_def;

typedef struct clq_clip_def {
    const char *name;
    uint32_t channel_count;
    const clq_channel_def *channels;
} clq_clip_def;

/* A named moment of a clip: a foot touches the ground, a hand lets go (clq_crowd_get_events). */
typedef struct clq_marker_def {
    uint32_t clip;
    float time_s; /* on the clip's own axis, in its length */
    const char *name;
} clq_marker_def;

/* A clip whose way over the ground is taken out of its poses, for a host to move the Reference Point by instead
 * (clq_template_get_root_motion): translation along x and z, and the turn about y, of one node in model space. */
typedef struct clq_root_motion_def {
    uint32_t clip;
    uint32_t node; /* whose way that is, hips for example; no node above it is animated by the clip */
} clq_root_motion_def;

typedef struct clq_template_def {
    uint32_t struct_bytes; /* set by clq_template_def_init */
    const char *name;
    uint32_t node_count;
    const clq_node_def *nodes;
    uint32_t joint_count;
    const clq_joint_def *joints;
    uint32_t image_count;
    const clq_image_def *images;
    uint32_t zone_count;
    const clq_zone_def *zones;
    uint32_t material_count;
    const clq_material_def *materials;
    uint32_t part_count;
    const clq_part_def *parts;
    uint32_t clip_count;
    const clq_clip_def *clips;
    uint32_t max_texture_px; /* larger images are reduced, keys unmixed; 0: 1024 */
    uint32_t dof_count;
    const clq_dof_def *dofs;
    /* Clips are sampled from rows at uniform rates, each the lowest that follows its channels within these errors at all
     * keys, between keys and between rows. STEP channels, and channels that no rate follows, are sampled as they are. */
    float motion_error_m; /* [model units, metres by convention] of any vertex or node, degrees of freedom at rest; 0: a
                               2000th of half the character's size, half a millimetre of a body; below 0: channels only */
    float motion_error_rad; /* that any node is turned; 0: 0.01 */
    uint32_t marker_count;
    const clq_marker_def *markers; /* in any order */
    uint32_t root_motion_count;
    const clq_root_motion_def *root_motions; /* of a clip at most one */
    uint32_t texture_set_count;              /* besides the materials' own; at most 63 */
    const clq_texture_set_def *texture_sets;
} clq_template_def;

static inline clq_template_def clq_template_def_init(void)
{
    clq_template_def def;
    unsigned char *p = (unsigned char *)&def;
    size_t i;
    for (i = 0; i < sizeof def; ++i) p[i] = 0;
    def.struct_bytes = (uint32_t)sizeof def;
    return def;
}

/* Splits a host's own arrays into a template. Copies what it needs: nothing of `def` is kept.
 *   out   [owner: host, until clq_template_destroy]
 * Fails: STRUCT_SIZE, ARGUMENT (first broken rule, named), LIMIT, OUT_OF_MEMORY. Threads: any; spreads over the
 * context's tasks, and the template is the same whatever these are. GL: none. Seed: S1 3. */
CLQ_API clq_status clq_template_build(clq_context *context, const clq_template_def *def, clq_template **out);

/* Gives up the host's hold on a template; NULL is ignored. Crowds that use it keep it alive. Threads: any one. */
CLQ_API void clq_template_destroy(clq_template *tmpl);

/* Writes a template in the prepared form: no reading of glTF, no splitting when it is loaded again.
 *   write   called in order with pieces of the file; returns 0 on success, anything else stops with IO
 * Fails: ARGUMENT, IO, OUT_OF_MEMORY. Threads: any. GL: none. */
CLQ_API clq_status clq_template_save(const clq_template *tmpl,
                                     int (*write)(void *user, const void *bytes, size_t size_bytes), void *user);

/* Loads what clq_template_save wrote. The bytes may be anything: a file that is cut, changed or of another version
 * is FORMAT.
 *   bytes   [size_bytes], not kept
 *   out     [owner: host, until clq_template_destroy]
 * Fails: ARGUMENT (NULL), FORMAT, OUT_OF_MEMORY. Threads: any. GL: none. */
CLQ_API clq_status clq_template_load(clq_context *context, const void *bytes, size_t size_bytes, clq_template **out);

#ifdef __cplusplus
}
#endif

#include <claque/template_info.h>

#endif
