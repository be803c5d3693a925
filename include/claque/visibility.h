/* Exact labels: which triangle of which individual each pixel shows, and what follows from it.
 *
 * A visibility picture shows each triangle in the colour of its number, flat, unlit and unblended, drawn with GL 1.1
 * from the vertices that clq_renderer_draw shows. The host draws it in place of the picture, reads it back, and asks
 * what its pixels show. Zones, points, normals and optical flow are computed in double precision from the vertices.
 * They do not depend on the depth buffer.
 *
 * Numbers. They go from individual to individual in the order of the draw list, and within an individual in the order
 * of clq_template_get_triangles. All triangles of its level have one, drawn or not. A pixel's number is red + 256 *
 * green + 65536 * blue. The host clears to 0 and draws its scenery in the colours of smaller numbers than first_number.
 * Where numbers need more than 24 bits, a second picture with upper_bits has the rest.
 *
 * Poses. An individual is drawn in the pose of its last tick (clq_crowd_def.period_near_s), but flow is that of exact
 * poses. So labels need a crowd without periods: period_near_s and period_far_s 0. */
#ifndef CLAQUE_VISIBILITY_H
#define CLAQUE_VISIBILITY_H

#include <claque/drawn_actor.h>
#include <claque/renderer.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef struct clq_visibility_def {
    uint32_t struct_bytes; /* set by clq_visibility_def_init */
    uint32_t first_number; /* (> 0) of the first triangle. Default 1 */
    bool upper_bits;       /* true: colours hold the numbers divided by 2^24. Default false */
    /* [clq_view_stats.visible] individuals with 0 are left out and keep their numbers. NULL (default): none is. The
     * pixels of an individual drawn alone are its whole silhouette. */
    const uint8_t *drawn;
} clq_visibility_def;

static inline clq_visibility_def clq_visibility_def_init(void)
{
    clq_visibility_def def;
    memset(&def, 0, sizeof def);
    def.struct_bytes = (uint32_t)sizeof def;
    def.first_number = 1;
    return def;
}

/* Gets how many triangles the numbers of a view's draw list cover.
 * Fails: ARGUMENT, BUSY. Threads: any. GL: none. */
CLQ_API clq_status clq_view_get_triangle_count(const clq_view *view, uint64_t *out);

/* Draws a visibility picture of a view's draw list, into the host's viewport and scissor. Holes of textures are kept.
 * Hooks are not called. Depth test GL_LEQUAL with writes; lighting, blending, fog, dithering, multisampling, texture
 * colours and polygon offset are off. All GL state is restored, whatever clq_renderer_def.guard says. The first picture
 * that shows holes loads a texture of one byte a texel for them, which the renderer keeps.
 *   out_stats   made by clq_draw_stats_init; may be NULL
 * Fails before drawing anything: STRUCT_SIZE, ARGUMENT (also a template that is not prepared, by name; first_number
 * 0), LIMIT (numbers beyond 2^32), GL_STATE (also fewer than 8 bits of a colour, or no depth buffer), GL_MISSING,
 * OUT_OF_MEMORY (of GL too), BUSY. Fails after drawing the rest: OUT_OF_MEMORY (the update left individuals out).
 * Threads: that of the current context. GL: see above. */
CLQ_API clq_status clq_renderer_draw_visibility(clq_renderer *renderer, clq_view *view, const clq_visibility_def *def,
                                                clq_draw_stats *out_stats);

/* A visibility picture that was read back. Its viewport was the whole picture. */
typedef struct clq_pixels {
    uint32_t struct_bytes; /* set by clq_pixels_init */
    uint32_t width_px, height_px;
    uint32_t first_number;   /* of the draw. Default 1 */
    const uint32_t *numbers; /* [width_px * height_px] rows from the bottom up, as glReadPixels gives them */
} clq_pixels;

static inline clq_pixels clq_pixels_init(void)
{
    clq_pixels pixels;
    memset(&pixels, 0, sizeof pixels);
    pixels.struct_bytes = (uint32_t)sizeof pixels;
    pixels.first_number = 1;
    return pixels;
}

/* The host's arrays for what pixels show, each [width_px * height_px] times the number given; NULL: not wanted. Pixels
 * without an individual get CLQ_NONE, 0 or NaN. Points are those at the pixels' centres; where GL filled a pixel whose
 * centre lies beside the triangle, the nearest point of it. A triangle that is seen edge on has no point there: its
 * weights, depth, position and normal are NaN, and a dirty triangle's zone is CLQ_NONE. */
typedef struct clq_pixel_channels {
    uint32_t struct_bytes; /* set by clq_pixel_channels_init */
    uint32_t *individuals; /* index for clq_view_get_drawn_actor */
    uint32_t *actors;      /* clq_actor.index1; 0: none */
    uint32_t *parts;       /* of the level */
    uint32_t *zones;       /* of the template, also in triangles with several zones; CLQ_NONE: no zone */
    uint32_t *triangles;   /* of the level */
    float *barycentric;    /* [3 *] weights of the triangle's corners, which sum to 1 */
    float *depth_m;        /* metres from the eye along the line of sight, not along the pixel's ray */
    double *positions;     /* [3 *] in the world */
    float *normals;        /* [3 *] in the world, of length 1, between the corners' normals, on the side that is seen */
} clq_pixel_channels;

CLQ_DEFINE_ZERO_INIT(clq_pixel_channels)

/* Computes what the pixels of a visibility picture show. The picture is of the view's present draw list.
 *   pixels     made by clq_pixels_init
 *   channels   made by clq_pixel_channels_init; the arrays are written by the context's tasks, row by row
 * Fails and writes nothing: STRUCT_SIZE, ARGUMENT (also a number beyond the list, with the pixel), OUT_OF_MEMORY, BUSY.
 * Threads: any, one at a time for a view. GL: none. */
CLQ_API clq_status clq_view_get_pixels(const clq_view *view, const clq_pixels *pixels,
                                       const clq_pixel_channels *channels);

/* Another time, and the camera then. */
typedef struct clq_flow_def {
    uint32_t struct_bytes; /* set by clq_flow_def_init */
    double time_s;
    clq_camera camera;
} clq_flow_def;

CLQ_DEFINE_ZERO_INIT(clq_flow_def)

/* Computes the optical flow to another time, earlier or later: where the points that the pixels show are in the picture
 * then. Individuals are posed exactly at that time and skinned at the level of the last update, so the points are the
 * same. They follow clips, fades, layers, mechanisms, tracks and root paths. Host mechanisms and the ground's height
 * are left out. They stand and play as the crowd's calls say now: a host that moves or plays actors itself makes those
 * calls for the other time first, and does not update the crowd in between.
 *   out_flow   [2 * width_px * height_px] pixels to the right and up. NaN: no individual, an actor that is not there at
 *              that time (its track), one that was destroyed, or a point behind the eye
 * Fails and writes nothing: as clq_view_get_pixels; ARGUMENT also for a time or camera that is not finite. Threads:
 * any, one at a time for a view. GL: none. */
CLQ_API clq_status clq_view_get_flow(const clq_view *view, const clq_pixels *pixels, const clq_flow_def *def,
                                     float *out_flow);

#ifdef __cplusplus
}
#endif

#endif
