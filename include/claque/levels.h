/* Levels of detail for a loaded character (libclaque-assets): fewer triangles for greater distances, chosen by how large
 * their error looks (S1 6). Seams stay shut, zones keep their borders, and what a level is off by is measured on poses of
 * the character's own clips. */
#ifndef CLAQUE_LEVELS_H
#define CLAQUE_LEVELS_H

#include <claque/assets.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef struct clq_levels_def {
    uint32_t struct_bytes; /* set by clq_levels_def_init */
    /* [target_count] triangles of all parts together, descending, each 4 or more; those that are not fewer than the
     * character's are skipped. NULL: halves down to 1040, eight levels to 490, then 250, 120, 60, 42, 30, 20, 14. */
    const uint32_t *targets;
    uint32_t target_count;
    float tolerance_px;    /* how large a level's error may look where it begins, in a view of 768 lines over 60 degrees
                              (other views: clq_view_set_height). Default 1 */
    float metres_per_unit; /* of the character. Default 1 */
    /* Levels of so many triangles and fewer are far ones, but for those of more than 128 that are nearer otherwise: one part
     * for all, seams and borders of zones hold no edges, and what triangles show is an image made for them; with 128 and
     * fewer each shows one zone. So are all from the first on
     * that seams and borders keep from its target by a twentieth, at which some zone would gain or lose more than 2 points of
     * the surface, or that is further off than a far one of fewer triangles. Of characters that are skinned or hang on several
     * nodes; far levels are skinned, so that CLQ_RIGID_MATRICES then places nobody of the template. 0: none. Default 250 */
    uint32_t proxy_max_triangles;
    /* 1: by OpenMesh's quadric alone, on the welded mesh, each corner taking what the vertex it comes to has there: what
     * levels are held against, not what anyone should draw. No level is a far one, and none is left out. Default 0 */
    uint32_t quadric_only;
} clq_levels_def;

static inline clq_levels_def clq_levels_def_init(void)
{
    clq_levels_def def;
    def.struct_bytes = (uint32_t)sizeof def;
    def.targets = NULL;
    def.target_count = 0;
    def.tolerance_px = 1.0f;
    def.metres_per_unit = 1.0f;
    def.proxy_max_triangles = 250;
    def.quadric_only = 0;
    return def;
}

/* What one level came to. Distances between places of the finest and of this level that lie nearest at rest. The surface is
 * what can be seen of it from anywhere at rest: skin under clothes does not count. */
typedef struct clq_level_report {
    float lod_min_m; /* it serves from here on, as clq_part_def.lod_min_m says */
    uint32_t triangle_count, vertex_count;
    float error_m;                  /* what it was chosen by: twice the root of the mean of squares in motion */
    float rest_max_m, rest_rms_m;   /* at rest */
    float posed_max_m, posed_rms_m; /* over eight poses of each of the first 32 clips */
    float wrong_zone;               /* [0, 1] share of the finest's area that shows another zone */
    uint32_t open_edges;            /* that the finest does not have */
    uint32_t flipped_uvs;           /* triangles that have turned over in their texture */
    float zone_area_error; /* [0, 1] by how much the share of area of any zone differs from the finest's at most */
} clq_level_report;

/* Gives an asset levels of detail. Parts that are hidden or have distances of their own stay as they are. Levels that
 * would serve nowhere are left out, and those of fewer than 20 triangles that cannot keep shares of zones within 2 points.
 *   def     NULL means clq_levels_def_init()
 *   out     [capacity] the levels, finest first; may be NULL with capacity 0
 *   count   how many there are, may be more than capacity; may be NULL
 * Fails: STRUCT_SIZE, ARGUMENT (nothing to decimate, targets), LIMIT, OUT_OF_MEMORY; the asset is then as it was.
 * Threads: any one; spreads over the context's tasks, and levels are the same whatever these are. GL: none. */
CLQ_API clq_status clq_asset_make_levels(clq_context *context, clq_asset *asset, const clq_levels_def *def,
                                         clq_level_report *out, uint32_t capacity, uint32_t *count);

/* How much of the surface that an asset shows at a distance each zone has, at rest, of what can be seen of it: what levels of
 * detail should not change.
 *   out   [capacity] shares of area, [0, 1], by zone in the asset's order, then what has no zone; NULL with capacity 0
 *   count zones and one more, may be more than capacity; may be NULL
 * Fails: ARGUMENT, OUT_OF_MEMORY. Threads: any. GL: none. */
CLQ_API clq_status clq_asset_get_zone_areas(const clq_asset *asset, float distance_m, float *out, uint32_t capacity,
                                            uint32_t *count);
CLQ_API const char *clq_asset_get_zone_name(const clq_asset *asset, uint32_t zone); /* "" beyond the last */

#ifdef __cplusplus
}
#endif

#endif
