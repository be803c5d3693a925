/* Levels of detail for a loaded character (libclaque-assets): meshes with fewer triangles for greater distances, chosen
 * by the size of their error in the picture (S1 6). Near levels are decimated: seams stay shut and zones keep their
 * borders. The coarsest levels may be proxies. Errors are measured in poses of the character's own clips. */
#ifndef CLAQUE_LEVELS_H
#define CLAQUE_LEVELS_H

#include <claque/assets.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef struct clq_levels_def {
    uint32_t struct_bytes; /* set by clq_levels_def_init */
    /* [target_count] triangles of all parts together, descending, each 4 or more. Targets that are not below the
     * character's count are skipped. With target_count 0: a half, a quarter and so on of the character's count, while
     * above 1300; then 1040, 934, 839, 753, 676, 607, 545, 490, 430, 375, 330, 290, 250, 205, 165, 120,
     * 84, 60, 42, 30, 20, 14 and 10. */
    const uint32_t *targets;
    uint32_t target_count;
    /* (> 0) the size of a level's error where the level begins, in a view of 768 lines over 60 degrees (other views:
     * clq_view_set_height). Default 1. */
    float tolerance_px;
    float metres_per_unit; /* (> 0) metres in a model unit of an actor of scale 1, as in clq_crowd_def. Default 1 */
    /* Levels of at most this many triangles are proxies: one mesh, no seams, a baked texture. Above 128 triangles a
     * decimated level is kept if its error is smaller; at 128 and below each triangle shows one zone. A decimated
     * level fails if it misses its target by 5 % or changes a zone's share of the surface by 2 points: it is left out.
     * Proxies replace all levels after the last that does not fail, and all from the first whose error is larger than
     * that of a coarser proxy. Only characters that are skinned or hang on several nodes get proxies. Proxies are
     * skinned, so CLQ_RIGID_MATRICES has no effect on the template. 0: no proxies. Default 250. */
    uint32_t proxy_max_triangles;
    /* True: a baseline for comparison, not for drawing. Decimates the welded mesh by OpenMesh's quadric alone, each
     * corner taking the attributes of its vertex; makes no proxies and leaves no level out. */
    bool quadric_only;
} clq_levels_def;

static inline clq_levels_def clq_levels_def_init(void)
{
    clq_levels_def def;
    memset(&def, 0, sizeof def);
    def.struct_bytes = (uint32_t)sizeof def;
    def.tolerance_px = 1.0f;
    def.metres_per_unit = 1.0f;
    def.proxy_max_triangles = 250;
    return def;
}

/* Makes levels of detail for an asset. Parts that are hidden or have distances of their own stay as they are. A level
 * is left out if no distance would select it, or if it has less than a tenth more triangles than the next one. A level
 * of fewer than 20 triangles is also left out in three cases. The share of a zone changes by more than 2 points of the
 * surface and by more than half of a pixel where the level begins. A larger zone nearly vanishes. Pictures from nine
 * sides show on average more than 28 % of wrong zones. Zones that cover less than a hundredth of the surface may vanish
 * from coarse levels. The levels do not depend on the context's tasks, which share the work. It may take seconds: a
 * note in the log says that it begins, with the number of triangles, and another that it ends, with that of the levels.
 *   def         NULL means clq_levels_def_init()
 *   out_count   the number of levels, for clq_asset_get_level_report; may be NULL
 * Fails: STRUCT_SIZE, ARGUMENT (nothing to decimate; targets that do not descend; a number out of its range), LIMIT
 * (triangles lie on one another: on average the centre of one lies in the bounding boxes of more than 512 others; or
 * memory: 2000 bytes for each triangle and 100 for each vertex are more than 16 MiB plus 64 times the bytes that were
 * read), OUT_OF_MEMORY; the asset then stays.
 * Threads: one per asset. GL: none. */
CLQ_API clq_status clq_asset_make_levels(clq_context *context, clq_asset *asset, const clq_levels_def *def,
                                         uint32_t *out_count);

/* Measures of a level against the finest one. Distances are between corresponding points, nearest to each other at
 * rest. The surface is the part that can be seen from some point at rest, without skin under clothes. */
typedef struct clq_level_report {
    uint32_t struct_bytes; /* set by clq_level_report_init */
    float lod_min_m;       /* the effective distance from which the level is used */
    uint32_t triangle_count, vertex_count;
    float error_m; /* selected the distance: twice the root mean square in motion, enlarged by the texture's error */
    float rest_max_m, rest_rms_m;   /* distances at rest */
    float posed_max_m, posed_rms_m; /* distances in eight poses of each of the first 32 clips */
    float wrong_zone;               /* [0, 1] share of the finest level's area that shows another zone */
    uint32_t open_edges;            /* open edges that the finest level does not have */
    uint32_t flipped_uvs;           /* triangles that have turned over in their texture */
    float zone_area_error;          /* [0, 1] largest change of any zone's share of the visible surface */
} clq_level_report;

CLQ_DEFINE_ZERO_INIT(clq_level_report)

/* Gets the measures of a level that the last clq_asset_make_levels of this asset made.
 *   level   0: the finest one
 *   out     made by clq_level_report_init
 * Fails: STRUCT_SIZE, ARGUMENT. Threads: any, not while the asset is changed. GL: none. */
CLQ_API clq_status clq_asset_get_level_report(const clq_asset *asset, uint32_t level, clq_level_report *out);

/* Gets the share of each zone in the visible surface of an asset at rest, at an effective distance. Levels of detail
 * should not change it.
 *   out         [capacity] shares of area in [0, 1], by zone in the asset's order, then the area without a zone; NULL
 *               with capacity 0
 *   out_count   zones and one more, which may be more than capacity; may be NULL
 * Fails: ARGUMENT, OUT_OF_MEMORY. Threads: any, not while the asset is changed. GL: none. */
CLQ_API clq_status clq_asset_get_zone_areas(const clq_asset *asset, float distance_m, float *out, uint32_t capacity,
                                            uint32_t *out_count);

/* Returns the name of a zone; "" beyond the last one. Threads: any, not while the asset is changed. GL: none. */
CLQ_API const char *clq_asset_get_zone_name(const clq_asset *asset, uint32_t zone);

#ifdef __cplusplus
}
#endif

#endif
