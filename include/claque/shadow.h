/* Shadows of a crowd on the ground (S1 9, S3 1): the vertices that the caches hold, thrown on a plane by a light and drawn
 * as darkness over what is there. Nobody is posed or skinned for it who is shown anyway. Several lights: a call for each. */
#ifndef CLAQUE_SHADOW_H
#define CLAQUE_SHADOW_H

#include <claque/renderer.h>

#ifdef __cplusplus
extern "C" {
#endif

/* How high the plane lies that somebody's shadow falls on, measured along `up`. */
typedef enum clq_shadow_ground {
    CLQ_SHADOW_GROUND_REFERENCE = 0, /* as its Reference Point; as its Skeleton Root where that follows the ground */
    CLQ_SHADOW_GROUND_PLANE = 1,     /* plane_height for all */
    CLQ_SHADOW_GROUND_HOST = 2       /* what height() says of that point */
} clq_shadow_ground;

/* All lengths in world units but those that say metres. */
typedef struct clq_shadow_def {
    uint32_t struct_bytes; /* set by clq_shadow_def_init */
    /* Light, in the world. [3] is 0: the direction to it, of any length, its rays being parallel, as the sun's are;
     * [3] is 1: where it is. Who is not below it by its whole bounding sphere throws no shadow then. */
    double light[4];
    double up[3]; /* of the ground, of any length; the light is above it */
    clq_shadow_ground ground;
    double plane_height;
    /* Called in clq_renderer_draw_shadows, on its thread, for each whose shadow is drawn; NaN: there is no ground, and
     * no shadow. Calls nothing of claque. */
    double (*height)(void *user, const double point[3]);
    void *user;
    float lift;     /* [>= 0] of shadows above the ground, so that depth tells them apart; default 0.01 */
    float rgb[3];   /* [0, 1] what a shadow darkens to; default black */
    float darkness; /* [0, 1] how far; default 0.5 */
    int32_t
        stencil_bit; /* 0 ...: this bit of the stencil buffer is claque's for the call; -1 (default): none is lent */
    float blob_distance_m; /* [>= 0] from the eye: from here on an ellipse stands for the mesh. Default: never */
    float max_distance_m;  /* [>= 0] from here on there is no shadow. Default: never */
} clq_shadow_def;

static inline clq_shadow_def clq_shadow_def_init(void)
{
    clq_shadow_def def;
    def.struct_bytes = (uint32_t)sizeof def;
    def.light[0] = 0.0, def.light[1] = 1.0, def.light[2] = 0.0, def.light[3] = 0.0;
    def.up[0] = 0.0, def.up[1] = 1.0, def.up[2] = 0.0;
    def.ground = CLQ_SHADOW_GROUND_REFERENCE;
    def.plane_height = 0.0;
    def.height = NULL;
    def.user = NULL;
    def.lift = 0.01f;
    def.rgb[0] = def.rgb[1] = def.rgb[2] = 0.0f;
    def.darkness = 0.5f;
    def.stencil_bit = -1;
    def.blob_distance_m = 1e30f;
    def.max_distance_m = 1e30f;
    return def;
}

typedef struct clq_shadow_stats {
    uint32_t individuals; /* whose shadow was drawn */
    uint32_t blobs;       /* of these, as ellipses */
    uint32_t shadow_only; /* of these, of whom nothing but the shadow is seen (clq_view_set_shadow) */
    uint32_t skinned;     /* of these, for whom no cache had room: skinned at this draw, as at any other */
    uint32_t draws;       /* glDrawElements calls */
    uint32_t triangles;   /* sent to GL */
    uint64_t vertices;    /* read from the caches */
} clq_shadow_stats;

/* Draws the shadows of a view's list as the last update left it: after the ground and whatever else stands in the picture,
 * before the crowd, with the depth of the former. It writes colour alone, no depth, and darkens every pixel at most once,
 * however many triangles and individuals overlap:
 *   with a stencil bit, which is cleared first (within the host's scissor) and is left set where shadows are, GL projects
 *   the cached vertices; the host's own stencil test is not heeded;
 *   without one, claque finds the pixels itself, in a mask of the viewport, and gives GL boxes of them. Where the grounds of
 *   two individuals are not the same plane and both shadows cover a pixel, the one earlier in the list has it.
 * The host's fog, clip planes, scissor and viewport are heeded. All of GL's state is afterwards as it was, whatever the
 * renderer's guard; one place of each attribute stack is needed. Hooks are not called. Holes of alpha-masked textures
 * throw shadow. Who is out of view but whose shadow is not: see clq_view_set_shadow.
 *   out_stats   may be NULL
 * Fails: STRUCT_SIZE, ARGUMENT, GL_STATE (also: the target has no such stencil bit), GL_MISSING, BUSY, OUT_OF_MEMORY (no
 * room for the mask, which grows with the viewport); nothing is drawn then. OUT_OF_MEMORY also as clq_renderer_draw.
 * Threads: as clq_renderer_draw. */
CLQ_API clq_status clq_renderer_draw_shadows(clq_renderer *renderer, clq_view *view, const clq_shadow_def *def,
                                             clq_shadow_stats *out_stats);

#ifdef __cplusplus
}
#endif

#endif
