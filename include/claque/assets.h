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
} clq_asset_options;

static inline clq_asset_options clq_asset_options_init(void)
{
    clq_asset_options options;
    options.struct_bytes = (uint32_t)sizeof options;
    options.base_folder = NULL;
    options.hidden_nodes = NULL;
    options.hidden_node_count = 0;
    options.memory_limit_bytes = 0;
    return options;
}

/* Loads glTF 2.0 or GLB, decided by content. The bytes may be anything.
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
 * zones); each of about 1040 triangles on one skeleton of 33 nodes. Clips: stand, walk, applaud, cheer; sit, sit_lean, sit_look, sit_talk, sit_applaud, sit_cheer, sit_laugh, sit_wave (4 to 9 s, loops
 * that begin and end in one pose and so may follow one another; the seat's top is 0.43 m above the feet, its front edge
 * 0.14 m behind the origin); rise and sit_down (2 s, once, from that pose to the beginning of stand and back);
 * stand_wave, stand_laugh, stand_applaud, stand_cheer (begin and end as stand).
 * Fails: ARGUMENT (names what there is), OUT_OF_MEMORY. */
CLQ_API clq_status clq_asset_builtin(clq_context *context, const char *name, clq_asset **out);
CLQ_API void clq_asset_destroy(clq_asset *asset);

typedef struct clq_asset_info {
    const char *name;
    uint32_t part_count, node_count, joint_count, clip_count, zone_count, image_count, material_count;
    uint32_t triangle_count, vertex_count, max_influences, morph_target_count;
    uint32_t hidden_part_count;
    uint32_t warning_count;
    float box_first[3], box_last[3]; /* of the rest pose, all parts that are not hidden */
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

/* Animated positions of all parts in file order (nodes depth first, primitives in order), in model space.
 *   clip     CLQ_NONE: the rest pose with default morph weights
 *   time_s   on the clip's own key axis; clamped to it
 *   out_xyz  [3 * vertex_count of clq_asset_info]
 * Fails: ARGUMENT (also capacity_floats too small), OUT_OF_MEMORY. Threads: any. */
CLQ_API clq_status clq_asset_positions(const clq_asset *asset, uint32_t clip, float time_s, float *out_xyz,
                                       size_t capacity_floats);

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
