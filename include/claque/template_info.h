/* What a template holds: the result of the split, and its clips, markers, zones, degrees of freedom, levels and
 * textures. */
#ifndef CLAQUE_TEMPLATE_INFO_H
#define CLAQUE_TEMPLATE_INFO_H

#include <claque/template.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Counts of the split (S1 3). Vertices and triangles are those of the finest level. */
typedef struct clq_template_info {
    uint32_t struct_bytes; /* set by clq_template_info_init */
    const char *name;      /* lives as long as the template */
    uint32_t node_count, joint_count, clip_count, zone_count, texture_count, surface_count;
    uint32_t vertex_count;       /* vertices that are skinned */
    uint32_t fused_vertex_count; /* with the copies that the fused strategy adds */
    uint32_t triangle_count, clean_count, dirty_count;
    uint32_t coincident_count; /* triangles with the same corners as another one: they tie in depth */
    uint32_t fused_triangle_count;
    float dirty_zone_mean; /* mean number of zones that a dirty triangle touches */
    uint32_t max_influences;
    /* The Sklsroot Bsphere (S0 4.1), in model units. It is computed to hold every vertex of every level in every pose
     * of every clip, with every degree of freedom anywhere in its range. Tests prove that over all clips for the
     * built-in people, and check other characters at samples. */
    float sklsroot_centre[3];
    float sklsroot_radius;
    uint32_t dof_count;
    uint32_t level_count; /* levels of detail: the finest, and one for each distance at which a part or node changes */
    uint32_t part_count;  /* parts of the finest level, which are culled one by one (S0 4.2) */
    uint64_t bytes;       /* memory of nodes, clips, textures and meshes, without names */
    uint32_t marker_count;
    uint32_t texture_set_count; /* 1 or more */
} clq_template_info;

typedef struct clq_clip_info {
    uint32_t struct_bytes; /* set by clq_clip_info_init */
    const char *name;
    float start_s, duration_s;
    uint32_t channel_count;
    /* The sampling of the clip, see clq_template_def.motion_error. All 0 for clips of an asset, and where all channels
     * are sampled from their keys. */
    float rate_hz;
    float error, error_rad; /* the largest errors measured; `error` in model units */
    uint32_t kept_count;    /* channels that are sampled from their keys */
    uint64_t bytes;         /* memory of rows, row tables and kept channels */
} clq_clip_info;

typedef struct clq_marker_info {
    uint32_t struct_bytes; /* set by clq_marker_info_init */
    const char *name;
    uint32_t clip;
    float time_s;
} clq_marker_info;

typedef struct clq_dof_info {
    uint32_t struct_bytes; /* set by clq_dof_info_init */
    const char *name;
    uint32_t node;
    clq_dof_kind kind;
    float min, max, rest;
} clq_dof_info;

/* A level of detail of the whole template: all parts and nodes between two effective distances (S0 5). */
typedef struct clq_level_info {
    uint32_t struct_bytes; /* set by clq_level_info_init */
    float lod_min_m;       /* the level is used from here up to lod_min_m of the next one */
    uint32_t triangle_count, vertex_count, part_count;
    uint32_t node_count; /* nodes that are evaluated */
} clq_level_info;

typedef struct clq_zone_info {
    uint32_t struct_bytes; /* set by clq_zone_info_init */
    const char *name;
    float colour[3];
    clq_hsb_range range;
    uint32_t clean_count; /* triangles that show this zone alone */
} clq_zone_info;

CLQ_DEFINE_ZERO_INIT(clq_template_info)
CLQ_DEFINE_ZERO_INIT(clq_clip_info)
CLQ_DEFINE_ZERO_INIT(clq_marker_info)
CLQ_DEFINE_ZERO_INIT(clq_dof_info)
CLQ_DEFINE_ZERO_INIT(clq_level_info)
CLQ_DEFINE_ZERO_INIT(clq_zone_info)

/* Get what a template holds. Strings live as long as the template.
 *   out   made by its _init function
 * Fail: STRUCT_SIZE, ARGUMENT (NULL, an index that is too large). Threads: any. GL: none. */
CLQ_API clq_status clq_template_get_info(const clq_template *tmpl, clq_template_info *out);
CLQ_API clq_status clq_template_get_clip(const clq_template *tmpl, uint32_t clip, clq_clip_info *out);
CLQ_API clq_status clq_template_get_marker(const clq_template *tmpl, uint32_t marker, clq_marker_info *out);
CLQ_API clq_status clq_template_get_zone(const clq_template *tmpl, uint32_t zone, clq_zone_info *out);
CLQ_API clq_status clq_template_get_dof(const clq_template *tmpl, uint32_t dof, clq_dof_info *out);
CLQ_API clq_status clq_template_get_level(const clq_template *tmpl, uint32_t level, clq_level_info *out);

/* Returns the name of a texture set, which lives as long as the template; "" for set 0 and beyond the last set.
 * Threads: any. GL: none. */
CLQ_API const char *clq_template_get_texture_set_name(const clq_template *tmpl, uint32_t set);

/* Returns the name of a node, which lives as long as the template; "" for a node without a name and beyond the last.
 * Threads: any. GL: none. */
CLQ_API const char *clq_template_get_node_name(const clq_template *tmpl, uint32_t node);

/* Return the index of the thing with this name, or CLQ_NONE. Threads: any. GL: none. */
CLQ_API uint32_t clq_template_find_clip(const clq_template *tmpl, const char *name);
CLQ_API uint32_t clq_template_find_zone(const clq_template *tmpl, const char *name);
CLQ_API uint32_t clq_template_find_node(const clq_template *tmpl, const char *name);
CLQ_API uint32_t clq_template_find_dof(const clq_template *tmpl, const char *name);
CLQ_API uint32_t clq_template_find_texture_set(const clq_template *tmpl, const char *name);

/* The host's arrays for the texels of a texture. A call with both arrays NULL asks for the size only. */
typedef struct clq_texels {
    uint32_t struct_bytes;        /* set by clq_texels_init */
    uint8_t *rgb;                 /* [3 * capacity] or NULL: the light and dark that colours are multiplied with */
    uint32_t *zones;              /* [capacity] or NULL: indices for clq_template_get_zone, CLQ_NONE in holes */
    size_t capacity;              /* texels that the arrays have room for, width_px * height_px or more */
    uint32_t width_px, height_px; /* written: the size of the texture */
} clq_texels;

CLQ_DEFINE_ZERO_INIT(clq_texels)

/* Copies a texture of a texture set, the row at v = 0 first (S1 Fig. 6). The size may differ between sets.
 *   set   0: the materials' own
 *   out   made by clq_texels_init; the host then sets the arrays and their capacity
 * Fails: STRUCT_SIZE, ARGUMENT (NULL, an index that is too large, a capacity that is too small). Threads: any. GL:
 * none. */
CLQ_API clq_status clq_template_get_texture(const clq_template *tmpl, uint32_t set, uint32_t texture, clq_texels *out);

/* The host's array for a picture. A call with pixels NULL asks for the size only. */
typedef struct clq_picture {
    uint32_t struct_bytes;        /* set by clq_picture_init */
    uint8_t *pixels;              /* [capacity_bytes] or NULL; the call says how many bytes a pixel has */
    size_t capacity_bytes;        /* room in pixels */
    uint32_t width_px, height_px; /* written: the size of the picture */
} clq_picture;

CLQ_DEFINE_ZERO_INIT(clq_picture)

/* Draws a texture's triangles over its zones, dirty ones marked (S1 Figs. 4 and 5), as RGB: 3 bytes a pixel.
 *   scale   [1, 16] pixels per texel
 *   out     made by clq_picture_init; the host then sets pixels and capacity_bytes
 * Fails: STRUCT_SIZE, ARGUMENT (also a capacity that is too small), OUT_OF_MEMORY. Threads: any. GL: none. */
CLQ_API clq_status clq_template_get_split_picture(const clq_template *tmpl, uint32_t texture, uint32_t scale,
                                                  clq_picture *out);

#ifdef __cplusplus
}
#endif

#endif
