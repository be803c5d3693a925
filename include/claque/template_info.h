/* Facts of a template, as it was split; included by claque/template.h. */
#ifndef CLAQUE_TEMPLATE_INFO_H
#define CLAQUE_TEMPLATE_INFO_H

#include <claque/template.h>

#ifdef __cplusplus
extern "C" {
#endif

/* What the split came to (S1 3). */
typedef struct clq_template_info {
    const char *name; /* lives as long as the template */
    uint32_t node_count, joint_count, clip_count, zone_count, texture_count, surface_count;
    uint32_t vertex_count;       /* that are skinned */
    uint32_t fused_vertex_count; /* with the copies that the fused strategy adds */
    uint32_t triangle_count, clean_count, dirty_count;
    uint32_t coincident_count; /* triangles that lie on another: they tie in depth */
    uint32_t fused_triangle_count;
    float dirty_zone_mean; /* zones that a dirty triangle touches, on average */
    uint32_t max_influences;
    float sklsroot_centre[3]; /* S0 4.1: holds every vertex of every level in every pose of every clip, with every */
    float sklsroot_radius;    /* degree of freedom anywhere in its range */
    uint32_t dof_count;
    uint32_t level_count; /* of detail: distances at which any part or node changes, and the finest */
    uint32_t part_count;  /* of the finest level, that are culled one by one (S0 4.2) */
    uint64_t bytes;       /* held in memory */
    uint32_t marker_count;
    uint32_t texture_set_count; /* 1 or more */
} clq_template_info;

typedef struct clq_clip_info {
    const char *name;
    float start_s, duration_s;
    uint32_t channel_count;
    /* As it is sampled, see clq_template_def.motion_error_m; all 0 of an asset, and where channels are sampled. */
    float rate_hz;
    float error_m, error_rad; /* the largest measured */
    uint32_t kept_count;      /* channels that are sampled as they are */
    uint64_t bytes;           /* of rows, their places and kept channels */
} clq_clip_info;

typedef struct clq_marker_info {
    const char *name;
    uint32_t clip;
    float time_s;
} clq_marker_info;

typedef struct clq_dof_info {
    const char *name;
    uint32_t node;
    clq_dof_kind kind;
    float min, max, rest;
} clq_dof_info;

/* One level of detail of the whole template: what all parts and nodes come to between two distances (S0 5). */
typedef struct clq_level_info {
    float lod_min_m; /* it serves from here on, up to the next one's */
    uint32_t triangle_count, vertex_count, part_count;
    uint32_t node_count; /* that are evaluated */
} clq_level_info;

typedef struct clq_zone_info {
    const char *name;
    float colour[3];
    clq_hsb_range range;
    uint32_t clean_count; /* triangles that lie in this zone alone */
} clq_zone_info;

/* Facts of a template. Strings live as long as it does. Fail: ARGUMENT. Threads: any. GL: none. */
CLQ_API clq_status clq_template_get_info(const clq_template *tmpl, clq_template_info *out);
CLQ_API clq_status clq_template_get_clip(const clq_template *tmpl, uint32_t clip, clq_clip_info *out);
CLQ_API clq_status clq_template_get_marker(const clq_template *tmpl, uint32_t marker, clq_marker_info *out);
CLQ_API clq_status clq_template_get_zone(const clq_template *tmpl, uint32_t zone, clq_zone_info *out);
CLQ_API clq_status clq_template_get_dof(const clq_template *tmpl, uint32_t dof, clq_dof_info *out);
CLQ_API clq_status clq_template_get_level(const clq_template *tmpl, uint32_t level, clq_level_info *out);

/* Index of what has this name, or CLQ_NONE. Threads: any. */
CLQ_API uint32_t clq_template_find_clip(const clq_template *tmpl, const char *name);
CLQ_API uint32_t clq_template_find_zone(const clq_template *tmpl, const char *name);
CLQ_API uint32_t clq_template_find_node(const clq_template *tmpl, const char *name);
CLQ_API uint32_t clq_template_find_dof(const clq_template *tmpl, const char *name);

/* A picture of a texture's triangles over its zones, dirty ones marked (S1 Figs. 4 and 5).
 *   scale          pixels a texel [1, 16]
 *   out_rgb        [3 * width * height] or NULL to ask for the size only
 *   capacity_bytes of out_rgb
 * Fails: ARGUMENT (also when capacity is too small), OUT_OF_MEMORY. Threads: any. GL: none. */
CLQ_API clq_status clq_template_split_picture(const clq_template *tmpl, uint32_t texture, uint32_t scale,
                                              uint8_t *out_rgb, size_t capacity_bytes, uint32_t *out_width_px,
                                              uint32_t *out_height_px);

/* A texture set's name, which lives as long as the template: "" of the first, and where there is none. And the set of this
 * name, or CLQ_NONE. Threads: any. */
CLQ_API const char *clq_template_texture_set_name(const clq_template *tmpl, uint32_t set);
CLQ_API uint32_t clq_template_find_texture_set(const clq_template *tmpl, const char *name);

/* What a texture holds, rows from the one at v = 0: the light and dark that an individual's colours are multiplied
 * with, and where each zone lies (S1 Fig. 6).
 *   out_rgb          [3 * width * height], or NULL
 *   out_zones        [width * height] indices for clq_template_get_zone, CLQ_NONE in holes; or NULL
 *   capacity_texels  width * height that the arrays have room for; with both NULL only the size is asked for
 * Fails: ARGUMENT (also when capacity is too small). Threads: any. GL: none. */
CLQ_API clq_status clq_template_get_texture(const clq_template *tmpl, uint32_t texture, uint8_t *out_rgb,
                                            uint32_t *out_zones, size_t capacity_texels, uint32_t *out_width_px,
                                            uint32_t *out_height_px);

/* The same of any texture set; its size may be another. */
CLQ_API clq_status clq_template_get_set_texture(const clq_template *tmpl, uint32_t set, uint32_t texture,
                                                uint8_t *out_rgb, uint32_t *out_zones, size_t capacity_texels,
                                                uint32_t *out_width_px, uint32_t *out_height_px);

#ifdef __cplusplus
}
#endif

#endif
