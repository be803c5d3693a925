/* What an asset holds: its parts, nodes and clips, and the warnings of loading. */
#ifndef CLAQUE_ASSET_INFO_H
#define CLAQUE_ASSET_INFO_H

#include <claque/template_info.h>

#ifdef __cplusplus
extern "C" {
#endif

/* A character as loaded, before it is split into a template. It may be changed by one thread at a time, and not while
 * another call uses it; nor may the tasks of that call use it. */
typedef struct clq_asset clq_asset;

typedef struct clq_asset_info {
    uint32_t struct_bytes; /* set by clq_asset_info_init */
    const char *name;
    uint32_t part_count, node_count, joint_count, clip_count, zone_count, image_count, material_count;
    uint32_t triangle_count, vertex_count, max_influences, morph_target_count;
    uint32_t hidden_part_count;
    uint32_t warning_count;
    float box_min[3], box_max[3]; /* of the rest pose in model units, without hidden parts */
} clq_asset_info;

typedef struct clq_asset_part {
    uint32_t struct_bytes; /* set by clq_asset_part_init */
    const char *name;
    const char *node_name;
    const char *material_name;
    uint32_t vertex_count, triangle_count, influence_count, morph_target_count;
    bool skinned, hidden;
    uint32_t topology; /* glTF's mode: 0 points ... 4 triangles ... 6 fan */
} clq_asset_part;

typedef struct clq_asset_node {
    uint32_t struct_bytes; /* set by clq_asset_node_init */
    const char *name;      /* "": the file gives it none */
    uint32_t parent;       /* a node before it; CLQ_NONE: it is a root */
    bool joint;            /* vertices follow it */
} clq_asset_node;

CLQ_DEFINE_ZERO_INIT(clq_asset_info)
CLQ_DEFINE_ZERO_INIT(clq_asset_part)
CLQ_DEFINE_ZERO_INIT(clq_asset_node)

/* Get what an asset holds. Strings live until the asset changes.
 *   out   made by its _init function
 * Fail: STRUCT_SIZE, ARGUMENT (NULL, an index that is too large), OUT_OF_MEMORY. Threads: any. GL: none. */
CLQ_API clq_status clq_asset_get_info(const clq_asset *asset, clq_asset_info *out);
CLQ_API clq_status clq_asset_get_part(const clq_asset *asset, uint32_t part, clq_asset_part *out);
CLQ_API clq_status clq_asset_get_node(const clq_asset *asset, uint32_t node, clq_asset_node *out);
CLQ_API clq_status clq_asset_get_clip(const clq_asset *asset, uint32_t clip, clq_clip_info *out);

/* Returns the name of a morph target of a part, as "targetNames" in the extras of its glTF mesh has it; "" where the
 * file gives it none, and beyond the last part or target. It lives until the asset changes. Threads: any. GL: none. */
CLQ_API const char *clq_asset_get_morph_name(const clq_asset *asset, uint32_t part, uint32_t target);

/* Returns a warning of loading as one sentence; "" beyond the last one. Threads: any. GL: none. */
CLQ_API const char *clq_asset_get_warning(const clq_asset *asset, uint32_t warning);

#ifdef __cplusplus
}
#endif

#endif
