/* clq_template: an immutable character that many individuals share: nodes, clips, zones, textures, and meshes that are
 * split into clean and dirty triangles (S1 3). Any number of threads may read a template. It is built here from the
 * host's own arrays or loaded from a prepared file; claque/assets.h builds it from glTF files and built-in characters.
 *
 * Model space is the actor's own space. Its origin is the Reference Point. y is up where claque needs an up direction:
 * root motion, ground, flights. */
#ifndef CLAQUE_TEMPLATE_H
#define CLAQUE_TEMPLATE_H

#include <claque/context.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef struct clq_template clq_template;

/* A node of the articulated structure (S0 3). Parents come before their children. */
typedef struct clq_node_def {
    const char *name; /* may be NULL */
    uint32_t parent;  /* index of an earlier node, or CLQ_NONE (default) */
    float translation[3];
    float rotation_xyzw[4]; /* of length 1 within 0.001; all zero means no rotation */
    float scale[3];         /* all zero means 1, 1, 1 */
    /* From this effective distance on the node and all nodes below it are not evaluated (S0 5.2). Rigid parts on
     * deactivated nodes must end at this distance, and their replacement on a remaining node must begin there. Weights
     * of skinned vertices move to the nearest remaining node. 0: the node is never deactivated. */
    float deactivation_m;
} clq_node_def;

static inline clq_node_def clq_node_def_init(void)
{
    clq_node_def def;
    memset(&def, 0, sizeof def);
    def.parent = CLQ_NONE;
    def.rotation_xyzw[3] = 1.0f;
    def.scale[0] = def.scale[1] = def.scale[2] = 1.0f;
    return def;
}

typedef enum clq_dof_kind {
    CLQ_DOF_ROTATION = 0,    /* a rotation about the axis, in radians */
    CLQ_DOF_TRANSLATION = 1, /* a translation along the axis, in model units */
    CLQ_DOF_MORPH = 2        /* an addend to the weight of a morph target of the node's parts */
} clq_dof_kind;

/* A degree of freedom of a node (S0 3): a number that control mechanisms write (claque/behave.h). It acts between the
 * node's rotation and its scale, on top of the clip, in the order of the list. */
typedef struct clq_dof_def {
    const char *name; /* may be NULL */
    uint32_t node;
    clq_dof_kind kind;
    uint32_t morph_target; /* of CLQ_DOF_MORPH: index of the target */
    float axis[3];         /* in the node's own frame, of length 1 within 0.001; unused by CLQ_DOF_MORPH */
    float min, max;        /* the range, min <= max */
    float rest;            /* the value that holds while no mechanism writes it; within the range */
} clq_dof_def;

CLQ_DEFINE_PLAIN_INIT(clq_dof_def)

/* A joint: a matrix that vertices may follow, namely the node's matrix times inverse_bind. */
typedef struct clq_joint_def {
    uint32_t node;
    const float *inverse_bind; /* [16]; NULL: identity */
} clq_joint_def;

CLQ_DEFINE_PLAIN_INIT(clq_joint_def)

typedef enum clq_wrap { CLQ_WRAP_REPEAT = 0, CLQ_WRAP_CLAMP = 1, CLQ_WRAP_MIRROR = 2 } clq_wrap;

/* The meaning of an image's alpha. Alpha is read as zone keys only where the host says so. */
typedef enum clq_alpha_meaning { CLQ_ALPHA_OPACITY = 0, CLQ_ALPHA_ZONE_KEYS = 1 } clq_alpha_meaning;

typedef enum clq_alpha_mode { CLQ_ALPHA_OPAQUE = 0, CLQ_ALPHA_MASK = 1 } clq_alpha_mode;

typedef struct clq_image_def {
    const char *name;             /* may be NULL */
    uint32_t width_px, height_px; /* [1, 16384] */
    const uint8_t *rgba;          /* [4 * width_px * height_px], the row at v = 0 first */
    clq_alpha_meaning alpha;
} clq_image_def;

CLQ_DEFINE_PLAIN_INIT(clq_image_def)

/* A colour range (S2 5). The hue range wraps when hue_min_deg > hue_max_deg. */
typedef struct clq_hsb_range {
    float hue_min_deg, hue_max_deg;       /* [0, 360] */
    float saturation_min, saturation_max; /* [0, 1], min <= max */
    float brightness_min, brightness_max; /* [0, 1], min <= max */
} clq_hsb_range;

/* Returns the range of all colours. */
static inline clq_hsb_range clq_hsb_range_init(void)
{
    clq_hsb_range range = {0.0f, 360.0f, 0.0f, 1.0f, 0.0f, 1.0f};
    return range;
}

/* A zone: a region of the surface that has one colour per individual (S1 3). */
typedef struct clq_zone_def {
    const char *name;
    uint32_t key;    /* [0, 255] the alpha of the zone's texels in images whose alpha holds zone keys */
    float colour[3]; /* [0, 1] RGB as glColor takes it, of individuals without colours of their own. Default white */
    clq_hsb_range range; /* the range that clq_actor_randomise_colours samples. Default: all colours */
} clq_zone_def;

static inline clq_zone_def clq_zone_def_init(void)
{
    clq_zone_def def;
    memset(&def, 0, sizeof def);
    def.colour[0] = def.colour[1] = def.colour[2] = 1.0f;
    def.range = clq_hsb_range_init();
    return def;
}

typedef struct clq_material_def {
    const char *name;     /* may be NULL */
    float base_colour[4]; /* as glColor takes it; all zero means white */
    uint32_t image;       /* CLQ_NONE (default): no image */
    clq_wrap wrap_s, wrap_t;
    clq_alpha_mode alpha_mode; /* MASK: texels below alpha_cutoff are holes; for images whose alpha is opacity */
    float alpha_cutoff;        /* default 0.5 */
    bool double_sided;
    uint32_t zone; /* the zone of everything drawn with the material; CLQ_NONE (default) if its image holds zone keys */
} clq_material_def;

static inline clq_material_def clq_material_def_init(void)
{
    clq_material_def def;
    memset(&def, 0, sizeof def);
    def.image = CLQ_NONE;
    def.alpha_cutoff = 0.5f;
    def.zone = CLQ_NONE;
    return def;
}

/* Images that replace the materials' own, so that individuals differ in more than colours (S1 1, S2 2.1). Texture set 0
 * is the materials' own; the sets of clq_template_def are 1, 2, ... A triangle is clean if it shows one zone whichever
 * set is used; so sets whose zones agree cost only their texels. */
typedef struct clq_texture_set_def {
    const char *name;
    /* [material_count] the image in place of each material's own, of any size; CLQ_NONE keeps the material's own. The
     * material must have an image, and the meaning of both alphas must agree. */
    const uint32_t *images;
} clq_texture_set_def;

CLQ_DEFINE_PLAIN_INIT(clq_texture_set_def)

/* The deltas of a morph target. */
typedef struct clq_morph_def {
    const float *positions; /* [3 * vertex_count] or NULL */
    const float *normals;   /* [3 * vertex_count] or NULL */
    float rest_weight;      /* parts on one node share their weights: the weights of the first part count */
} clq_morph_def;

CLQ_DEFINE_PLAIN_INIT(clq_morph_def)

/* A triangle mesh. A skinned part has joints and weights. A rigid part hangs on `node` and has neither. */
typedef struct clq_part_def {
    const char *name;  /* may be NULL */
    uint32_t node;     /* rigid: the node that carries it. Morphed: the node by which clips address its weights */
    uint32_t material; /* CLQ_NONE (default): white and one-sided */
    uint32_t vertex_count;
    const float *positions;   /* [3 * vertex_count] */
    const float *normals;     /* [3 * vertex_count]; NULL: flat */
    const float *uvs;         /* [2 * vertex_count] or NULL */
    const uint8_t *colours;   /* [4 * vertex_count] as GL takes them, or NULL */
    uint32_t influence_count; /* [0, 64] per vertex; 0: rigid */
    const uint32_t *joints;   /* [influence_count * vertex_count] indices of clq_template_def.joints */
    const float *weights;     /* [influence_count * vertex_count]; the sum of each vertex is 1 within 0.001 */
    uint32_t index_count;     /* three per triangle; 0: the vertices in order */
    const uint32_t *indices;
    uint32_t morph_count;
    const clq_morph_def *morphs;
    /* The part is drawn at effective distances in [lod_min_m, lod_max_m) (S0 5.1). The levels of detail of one piece
     * are several parts with adjoining ranges; pieces are independent. lod_max_m 0: no end. */
    float lod_min_m, lod_max_m;
} clq_part_def;

static inline clq_part_def clq_part_def_init(void)
{
    clq_part_def def;
    memset(&def, 0, sizeof def);
    def.material = CLQ_NONE;
    return def;
}

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

/* A channel: one animated property of one node, as in glTF 2.0. Morph weights are addressed by the node of the part;
 * all parts on one node share them. */
typedef struct clq_channel_def {
    uint32_t node;
    clq_channel_target target;
    clq_interpolation interpolation; /* default LINEAR */
    uint32_t key_count;              /* 1 or more */
    const float *times_s;            /* [key_count], strictly ascending */
    /* [key_count * components]. Components: 3 of translation and scale, 4 of rotation (x, y, z, w), or one weight for
     * each morph target. Cubic splines have three of these for each key: in-tangent, value, out-tangent. */
    const float *values;
} clq_channel_def;

static inline clq_channel_def clq_channel_def_init(void)
{
    clq_channel_def def;
    memset(&def, 0, sizeof def);
    def.interpolation = CLQ_INTERPOLATION_LINEAR;
    return def;
}

typedef struct clq_clip_def {
    const char *name;
    uint32_t channel_count;
    const clq_channel_def *channels; /* [channel_count] */
} clq_clip_def;

CLQ_DEFINE_PLAIN_INIT(clq_clip_def)

/* A marker: a named time of a clip, such as a foot contact (clq_crowd_get_events). */
typedef struct clq_marker_def {
    uint32_t clip;
    float time_s; /* on the clip's own axis, within its length */
    const char *name;
} clq_marker_def;

CLQ_DEFINE_PLAIN_INIT(clq_marker_def)

/* Takes the root motion of a clip out of its poses: translation along x and z, and the rotation about y, of one node in
 * model space. The host moves the Reference Point by it instead (clq_template_get_root_motion). */
typedef struct clq_root_motion_def {
    uint32_t clip;
    uint32_t node; /* hips, for example; the clip must animate no node above it */
} clq_root_motion_def;

CLQ_DEFINE_PLAIN_INIT(clq_root_motion_def)

typedef struct clq_template_def {
    uint32_t struct_bytes; /* set by clq_template_def_init */
    const char *name;      /* may be NULL */
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
    uint32_t max_texture_px; /* larger images are reduced without mixing keys; 0: 1024 */
    uint32_t dof_count;
    const clq_dof_def *dofs;
    /* Clips are sampled from rows at uniform rates. Each clip gets the lowest rate that follows its channels within
     * these two errors, at all keys, between keys and between rows. STEP channels, and channels that no rate follows,
     * are sampled from their keys. */
    /* Error of the position of any vertex or node with degrees of freedom at rest, in model units. 0: a 2000th of half
     * the character's size, half a millimetre for a person. Negative: all channels are sampled from their keys. */
    float motion_error;
    float motion_error_rad; /* error of the rotation of any node; 0: 0.01 */
    uint32_t marker_count;
    const clq_marker_def *markers; /* in any order */
    uint32_t root_motion_count;
    const clq_root_motion_def *root_motions; /* one per clip at most */
    uint32_t texture_set_count;              /* without the materials' own; 63 at most */
    const clq_texture_set_def *texture_sets;
} clq_template_def;

CLQ_DEFINE_ZERO_INIT(clq_template_def)

/* Builds a template from the host's own arrays. It copies what it needs and keeps nothing of `def`. The template does
 * not depend on the context's tasks, which share the work.
 *   out   owned by the host until clq_template_destroy
 * The call takes at most 16 MiB plus 64 bytes for each byte that was read or passed; bytes after decompression and 4
 * for each pixel count as read. The number of poses that it evaluates is limited likewise. Clips whose rows would take
 * more keep their channels, and show the same poses. Bounding spheres that would take more are larger. A template has
 * at most 64 levels of detail. Of a level with more than 64 parts, neighbouring parts are culled as one.
 * Fails: STRUCT_SIZE, ARGUMENT (names the first broken rule), LIMIT (what else would take more, with both numbers),
 * OUT_OF_MEMORY. Threads: any. GL: none. S1 3. */
CLQ_API clq_status clq_template_build(clq_context *context, const clq_template_def *def, clq_template **out);

/* Ends the host's ownership of a template; NULL is ignored. Crowds, renderers, locomotions and records that use the
 * template keep it alive.
 * Threads: any. GL: none. */
CLQ_API void clq_template_destroy(clq_template *tmpl);

/* Writes a prepared template: loading it needs neither glTF nor splitting.
 *   write   gets the whole file in one piece
 * Fails: ARGUMENT, IO (write refused), OUT_OF_MEMORY, CALLBACK. Threads: any. GL: none. */
CLQ_API clq_status clq_template_save(const clq_template *tmpl, clq_write_function write, void *user);

/* Loads a prepared template. The bytes may be anything: a file that is cut off, changed or of another version fails
 * with FORMAT. The log gets the warnings of clq_template_build again.
 *   bytes   [size_bytes], not kept
 *   out     owned by the host until clq_template_destroy
 * Fails: ARGUMENT (NULL), FORMAT, OUT_OF_MEMORY. Threads: any. GL: none. */
CLQ_API clq_status clq_template_load(clq_context *context, const void *bytes, size_t size_bytes, clq_template **out);

#ifdef __cplusplus
}
#endif

#endif
