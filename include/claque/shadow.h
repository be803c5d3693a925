/* Shadows of a crowd on the ground (S1 9, S3 1). The vertices in the caches are projected onto a plane from a light,
 * and the pixels that they cover are darkened. Individuals that are visible anyway are neither posed nor skinned for
 * it. Several lights take several calls. */
#ifndef CLAQUE_SHADOW_H
#define CLAQUE_SHADOW_H

#include <claque/renderer.h>

#ifdef __cplusplus
extern "C" {
#endif

/* The height, along `up`, of the plane that the shadow of an individual falls on. */
typedef enum clq_shadow_ground {
    /* That of its Reference Point, or of its Skeleton Root if that follows the ground. */
    CLQ_SHADOW_GROUND_REFERENCE = 0,
    CLQ_SHADOW_GROUND_PLANE = 1, /* plane_height for all */
    CLQ_SHADOW_GROUND_HOST = 2   /* the result of height() */
} clq_shadow_ground;

typedef struct clq_shadow_def {
    uint32_t struct_bytes; /* set by clq_shadow_def_init */
    /* The light, in the world. light[3] is 0: the direction to a light with parallel rays, such as the sun, of any
     * length. light[3] is 1: the position of the light; an individual whose bounding sphere is not wholly below it has
     * no shadow. Default: straight above. */
    double light[4];
    /* The ground's up direction, of any length. A direction to the light rises above the ground by a sine of 0.02 or
     * more. Default 0, 1, 0. */
    double up[3];
    clq_shadow_ground ground;
    double plane_height; /* in world units, of CLQ_SHADOW_GROUND_PLANE */
    /* clq_renderer_draw_shadows calls it on its thread for each individual with a shadow; NaN: no shadow. */
    clq_height_function height;
    void *user;
    /* [>= 0] the height of shadows above the ground, in world units, to separate their depths. Default 0.01. */
    float lift;
    float rgb[3];          /* [0, 1] the colour that a shadow darkens to. Default black */
    float darkness;        /* [0, 1] how far. Default 0.5 */
    int32_t stencil_bit;   /* [0, 31] a bit of the stencil buffer lent to the call; -1 (default): none */
    float blob_distance_m; /* [>= 0] eyeDistance from which an ellipse replaces the mesh. Default: never */
    float max_distance_m;  /* [>= 0] eyeDistance from which there is no shadow. Default: never */
} clq_shadow_def;

static inline clq_shadow_def clq_shadow_def_init(void)
{
    clq_shadow_def def;
    memset(&def, 0, sizeof def);
    def.struct_bytes = (uint32_t)sizeof def;
    def.light[1] = 1.0;
    def.up[1] = 1.0;
    def.lift = 0.01f;
    def.darkness = 0.5f;
    def.stencil_bit = -1;
    def.blob_distance_m = 1e30f;
    def.max_distance_m = 1e30f;
    return def;
}

typedef struct clq_shadow_stats {
    uint32_t struct_bytes; /* set by clq_shadow_stats_init */
    uint32_t individuals;  /* individuals whose shadow was drawn */
    uint32_t blobs;        /* of these, shadows drawn as ellipses */
    uint32_t shadow_only;  /* of these, individuals of which only the shadow is in view (clq_view_set_shadow) */
    uint32_t draws;        /* calls of glDrawElements */
    uint32_t triangles;    /* sent to GL */
    uint64_t vertices;     /* read from what the update skinned */
} clq_shadow_stats;

CLQ_DEFINE_ZERO_INIT(clq_shadow_stats)

/* Draws the shadows of a view's draw list as the last update left it. Call it after the ground and the rest of the
 * scene are drawn and before the crowd; it needs their depth. It writes colour and no depth, and darkens every pixel at
 * most once:
 *   With a stencil bit: the bit is cleared first (within the host's scissor) and is left set where shadows are. GL
 *   projects the cached vertices. The host's own stencil test is not applied.
 *   Without one: claque finds the pixels in a mask of the viewport and gives GL boxes of them. Where two shadows on
 *   different planes cover a pixel, that of the individual earlier in the list counts.
 * The host's fog, clip planes, scissor and viewport apply. All GL state is restored, whatever the renderer's guard;
 * each attribute stack needs one free entry. Hooks are not called. Holes of alpha-masked textures throw shadow. For
 * individuals out of view whose shadow is in view see clq_view_set_shadow.
 *   out_stats   made by clq_shadow_stats_init; may be NULL
 * Fails before drawing anything: STRUCT_SIZE, ARGUMENT, GL_STATE (also a stencil bit that the target lacks),
 * GL_MISSING, BUSY, OUT_OF_MEMORY (no room for the mask, which grows with the viewport). Fails after drawing the rest:
 * OUT_OF_MEMORY, as clq_renderer_draw. Fails after drawing a part: CALLBACK (height threw an exception; no later shadow
 * is drawn), GL_MISSING (the context was lost meanwhile). Threads: as clq_renderer_draw. GL:
 * see above. */
CLQ_API clq_status clq_renderer_draw_shadows(clq_renderer *renderer, clq_view *view, const clq_shadow_def *def,
                                             clq_shadow_stats *out_stats);

#ifdef __cplusplus
}
#endif

#endif
