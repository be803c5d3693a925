/* libclaque-assets: files in, built-in figures. Separate from libclaque, which needs libc and libstdc++ alone and loads
 * templates that were prepared with clq_template_save. Working memory comes from the C++ heap; templates are the
 * context's. */
#ifndef CLAQUE_ASSETS_H
#define CLAQUE_ASSETS_H

#include <claque/template.h>

#ifdef __cplusplus
extern "C" {
#endif

/* A character as loaded, before it is split. */
typedef struct clq_asset clq_asset;

typedef struct clq_asset_options {
    uint32_t struct_bytes;   /* set by clq_asset_options_init */
    const char *base_folder; /* where external buffers and images lie; NULL: they are refused (load) or the file's own
                                folder (load_file) */
    const char *const
        *hidden_nodes; /* [hidden_node_count] names: these and what hangs on them is left out of templates */
    uint32_t hidden_node_count;
    uint64_t memory_limit_bytes; /* 0: 1 GiB */
    double motion_unit_m;        /* BVH: metres a unit of the file, which does not say; 0: 1 */
} clq_asset_options;

static inline clq_asset_options clq_asset_options_init(void)
{
    clq_asset_options options;
    options.struct_bytes = (uint32_t)sizeof options;
    options.base_folder = NULL;
    options.hidden_nodes = NULL;
    options.hidden_node_count = 0;
    options.memory_limit_bytes = 0;
    options.motion_unit_m = 0;
    return options;
}

/* What a glTF file may say beside what the format knows, in `extras`:
 *   of an animation   "extras": {"claque": {"markers": [{"name": "left foot down", "time_s": 0.25}],
 *                                           "root_motion": "hips"}}
 *     markers: named moments (clq_marker_def), in any order, time_s on the axis of its keys, from the first to the last;
 *     at most 4096 of one animation. root_motion: the name of the node whose way over the ground is taken out
 *     (clq_root_motion_def); one that is animated from above is refused when the template is built. Both go with the clip
 *     in clq_asset_add_clips.
 *   of a node         "extras": {"claque": {"deactivation_m": 40, "lod_m": [0, 40], "dofs": [{"name": "gaze yaw", "kind":
 *                                           "rotation", "axis": [0, 1, 0], "min": -0.7, "max": 0.7, "rest": 0}]}}
 *     as clq_node_def, clq_part_def and clq_dof_def have them; kinds are rotation, translation, and morph with
 *     "morph_target" in place of the axis
 * Members that are not known are passed over; known ones that break these rules are refused as FORMAT, by their place in
 * the file. */

/* Loads glTF 2.0, GLB or BVH, decided by content. The bytes may be anything. A BVH file becomes a skeleton without parts
 * and one clip, named after the file (clq_asset_load: "motion"): nothing to build a template from, but a source for
 * clq_asset_add_clips.
 *   options   NULL means clq_asset_options_init()
 *   out       [owner: host, until clq_asset_destroy]
 * Fails: FORMAT, UNSUPPORTED (the feature is named), LIMIT, IO, OUT_OF_MEMORY. Warnings go to the context's log.
 * Threads: any. GL: none. */
CLQ_API clq_status clq_asset_load(clq_context *context, const void *bytes, size_t size_bytes,
                                  const clq_asset_options *options, clq_asset **out);
CLQ_API clq_status clq_asset_load_file(clq_context *context, const char *path, const clq_asset_options *options,
                                       clq_asset **out);

/* A figure that needs no file: "citizen" (a man in a girded tunic, 8 zones), "patrician" (a rich woman in stola and
 * palla, 10 zones), "decurion" (an older man in a toga, 9 zones), "plebeian" (a young working man in an exomis, 9
 * zones); each of about 1040 triangles on one skeleton of 33 nodes. Clips: stand, walk, applaud, cheer; sit, sit_lean,
 * sit_look, sit_talk, sit_applaud, sit_cheer, sit_laugh, sit_wave (4 to 9 s, loops that begin and end in one pose and so
 * may follow one another; the seat's top is 0.43 m above the feet, its front edge 0.14 m behind the origin); rise and
 * sit_down (2 s, once, from that pose to the beginning of stand and back); stand_wave, stand_laugh, stand_applaud,
 * stand_cheer (begin and end as stand); jog, in step with walk: the left foot comes down at the beginning of both, the
 * right one in the middle.
 * Fails: ARGUMENT (names what there is), OUT_OF_MEMORY. */
CLQ_API clq_status clq_asset_builtin(clq_context *context, const char *name, clq_asset **out);

/* One of the four people with more clips: its own nineteen, and variants of each in turn, until there are clip_count.
 * They differ in tempo, timing, amplitude, the hand that leads and a sway of their own, and are named "sit_talk.03" and
 * the like; what holds for a clip (loops, seats, common beginnings and ends) holds for its variants. The same bytes on
 * every call. S1 8: 150 clips for everybody.
 *   clip_count   [19, 2000]
 * Fails: ARGUMENT (names what there is), OUT_OF_MEMORY. Threads: any. GL: none. */
CLQ_API clq_status clq_asset_builtin_varied(clq_context *context, const char *name, uint32_t clip_count,
                                            clq_asset **out);
CLQ_API void clq_asset_destroy(clq_asset *asset);

typedef struct clq_asset_info {
    const char *name;
    uint32_t part_count, node_count, joint_count, clip_count, zone_count, image_count, material_count;
    uint32_t triangle_count, vertex_count, max_influences, morph_target_count;
    uint32_t hidden_part_count;
    uint32_t warning_count;
    float box_min[3], box_max[3]; /* of the rest pose, all parts that are not hidden */
} clq_asset_info;

typedef struct clq_asset_part {
    const char *name;
    const char *node_name;
    const char *material_name;
    uint32_t vertex_count, triangle_count, influence_count, morph_target_count;
    int32_t skinned, hidden;
    uint32_t topology; /* glTF's mode: 0 points ... 4 triangles ... 6 fan */
} clq_asset_part;

CLQ_API clq_status clq_asset_get_info(const clq_asset *asset, clq_asset_info *out);
CLQ_API clq_status clq_asset_get_part(const clq_asset *asset, uint32_t part, clq_asset_part *out);
CLQ_API clq_status clq_asset_get_clip(const clq_asset *asset, uint32_t clip, clq_clip_info *out);
CLQ_API const char *clq_asset_get_warning(const clq_asset *asset, uint32_t warning); /* "" beyond the last */

/* Gives an asset one more texture set (clq_texture_set_def), for individuals that differ in more than colours.
 * KHR_materials_variants of a glTF file are such sets already; the four built-in people have a second one each.
 *   name      by which clq_template_find_texture_set finds it
 *   images    [material_count of clq_asset_info], copied; rgba NULL: the material's own. Alpha must mean what it means in the
 *             material's own image, which there must be
 * Fails: ARGUMENT, LIMIT (63 sets), OUT_OF_MEMORY; the asset is then as it was. Threads: any one. GL: none. */
CLQ_API clq_status clq_asset_add_texture_set(clq_context *context, clq_asset *asset, const char *name,
                                             const clq_image_def *images, uint32_t image_count);

/* Animated positions of all parts in file order (nodes depth first, primitives in order), in model space.
 *   clip     CLQ_NONE: the rest pose with default morph weights
 *   time_s   on the clip's own key axis; clamped to it
 *   out_xyz  [3 * vertex_count of clq_asset_info]
 * Fails: ARGUMENT (also capacity_floats too small), OUT_OF_MEMORY. Threads: any. */
CLQ_API clq_status clq_asset_positions(const clq_asset *asset, uint32_t clip, float time_s, float *out_xyz,
                                       size_t capacity_floats);

/* What of a joint answers the rest pose of the clips' skeleton. */
typedef enum clq_rest_alignment {
    CLQ_REST_KEEP = 0, /* its own rest */
    CLQ_REST_ALIGN =
        1 /* its rest turned so that the bone points where the other's does: A-poses against T-poses. A joint
                          that has no bound joint below it, or several, turns as the bound one above it */
} clq_rest_alignment;

typedef struct clq_joint_pair {
    const char *source; /* of the clips' skeleton */
    const char *target; /* of the character; each once at most */
    clq_rest_alignment rest;
} clq_joint_pair;

/* A joint that nothing of the source answers, and that gives way to one that is bound: cloth to a thigh. One that stands in
 * several of these goes with whichever leader turns it farthest; of leaders that turn away from the side on which it lies,
 * 0.3 of the share counts. */
typedef struct clq_follower {
    const char *joint, *leader; /* of the character */
    float share;                /* [0, 1] of the leader's turn from its rest, as the joint's parent sees it */
} clq_follower;

typedef enum clq_retarget_mode {
    CLQ_RETARGET_AUTOMATIC = 0, /* channels, where the skeletons agree and none of first_s, last_s and close_s is set */
    CLQ_RETARGET_CHANNELS = 1,  /* keys, steps and splines as they are */
    CLQ_RETARGET_MOTION = 2 /* joints turn from their rest in model space as the source's do; the topmost one goes the
                              source's way, scaled by the legs and set down so that the feet stand on y = 0 */
} clq_retarget_mode;

typedef enum clq_root_travel {
    CLQ_ROOT_TRAVEL_IN_PLACE = 0, /* without the straight way from the clip's first place to its last */
    CLQ_ROOT_TRAVEL_KEEP = 1
} clq_root_travel;

typedef struct clq_clips_def {
    uint32_t struct_bytes;        /* set by clq_clips_def_init */
    const clq_joint_pair *joints; /* [joint_count]; none: joints of equal names answer each other */
    uint32_t joint_count;
    const char *const *clips; /* [clip_count] names in the source; none: all of them */
    uint32_t clip_count;
    const char *prefix; /* of the names of what is added; may be NULL */
    clq_retarget_mode mode;
    /* The rest is for CLQ_RETARGET_MOTION. */
    clq_root_travel travel;
    float rate_hz;                 /* of keys, [1, 1000]; 0: 30 */
    float start_s, end_s;          /* what is taken of each clip, from its start on; last_s 0: to its end */
    const clq_follower *followers; /* [follower_count] */
    uint32_t follower_count;
    float close_s; /* so long before its end it begins to turn into its first pose, so that it loops; 0: never */
} clq_clips_def;

static inline clq_clips_def clq_clips_def_init(void)
{
    clq_clips_def def;
    unsigned char *p = (unsigned char *)&def;
    size_t i;
    for (i = 0; i < sizeof def; ++i) p[i] = 0;
    def.struct_bytes = (uint32_t)sizeof def;
    return def;
}

typedef struct clq_clips_report {
    clq_retarget_mode mode; /* that was taken */
    uint32_t clip_count;    /* that were added, as the last of the asset's */
    uint32_t joint_count;   /* that are bound */
} clq_clips_report;

/* Adds clips of one asset to another, before templates are built from it. Joints are bound by name. What is not bound is
 * said by name and number: to the context's log, and as warnings of the asset. A name that is taken gets a number.
 *   source   any asset with clips: glTF with or without meshes, BVH, a built-in figure; not kept
 *   def      NULL means clq_clips_def_init()
 *   report   may be NULL
 * Fails, with the asset as it was: STRUCT_SIZE, ARGUMENT (nothing is bound; a clip that is not there; numbers out of
 * range), LIMIT, OUT_OF_MEMORY. Threads: any, but no other call with this asset at the same time. GL: none. */
CLQ_API clq_status clq_asset_add_clips(clq_context *context, clq_asset *asset, const clq_asset *source,
                                       const clq_clips_def *def, clq_clips_report *report);

/* Splits it into a template (see clq_template_build). max_texture_px 0: 1024. */
CLQ_API clq_status clq_asset_build(clq_context *context, const clq_asset *asset, uint32_t max_texture_px,
                                   clq_template **out);

/* The short ways: load or make, split, forget the rest. */
CLQ_API clq_status clq_template_load_gltf(clq_context *context, const void *bytes, size_t size_bytes,
                                          const clq_asset_options *options, clq_template **out);
CLQ_API clq_status clq_template_builtin(clq_context *context, const char *name, clq_template **out);

#ifdef __cplusplus
}
#endif

#endif
