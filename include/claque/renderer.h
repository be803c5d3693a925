/* clq_renderer: draws the draw lists of views with GL 1.1 only. A host has one renderer per GL context.
 *
 * claque links no GL. The renderer asks the host for the functions of OpenGL 1.1 once, when it is created.
 *
 * GL state. The renderer inherits the host's viewport, scissor, lights, fog, clip planes, stencil and shade model
 * (except where clq_renderer_def.flat_triangles applies). Surfaces of materials without lighting turn GL_LIGHTING off,
 * and those that emit set GL_EMISSION of both faces; the host's own comes back after them, in every guard mode. The
 * renderer sets the state that its picture depends on: blending off, alpha test, depth test GL_LEQUAL with writes,
 * alpha writes masked, face culling, one texture with GL_MODULATE, no texture generation, an identity texture matrix,
 * colour material on ambient and diffuse, GL_NORMALIZE, its own matrices.
 *
 * Hooks (clq_actor_set_hooks). They are called around the drawing of their actor, not where the actor is not drawn.
 *   State on entry: the view's projection, the actor's own model-view matrix, GL_MODELVIEW as the matrix mode, all
 *   client arrays off, and texture 0 bound, so that claque's textures are out of reach. All attributes are pushed
 *   around the pair. What before() sets of the inherited state, of materials and of the RGB mask acts on this actor and
 *   is gone after after(). claque sets its own state anew after each call.
 *   after() may pop what before() pushed on a stack. Entries that are left are popped; an open display list, selection
 *   or feedback is ended. A hook must not pop what neither has pushed.
 *   A texture that before() binds for use is sampled as it is. It needs GL_NEAREST in both filters and no mipmaps,
 *   because its alpha holds the zone keys of the template's texture and filtering mixes keys.
 *   State that belongs to no attribute group, such as pixel maps, stays.
 *   A program, buffer or other object newer than GL 1.1 that before() leaves bound keeps its actor from being drawn. If
 *   it is still bound after after(), all later actors are skipped too. The draw then fails with GL_STATE and their
 *   names. */
#ifndef CLAQUE_RENDERER_H
#define CLAQUE_RENDERER_H

#include <claque/view.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef struct clq_renderer clq_renderer;

/* How zones get the colours of individuals in GL. All strategies give the same RGB and depth. */
typedef enum clq_draw_strategy {
    CLQ_STRATEGY_FUSED = 0,   /* one draw per surface */
    CLQ_STRATEGY_BINNED = 1,  /* dirty triangles only in the passes of the zones that they touch */
    CLQ_STRATEGY_PER_ZONE = 2 /* one draw per clean bin, and all dirty triangles once per zone (S1 3, S2 2.1) */
} clq_draw_strategy;

/* How much of the host's GL state is restored after a draw. */
typedef enum clq_guard {
    CLQ_GUARD_FULL = 0,    /* everything */
    CLQ_GUARD_MINIMAL = 1, /* matrices and client state; the list in passes/guard.h is left as claque set it */
    CLQ_GUARD_NONE = 2     /* nothing: all of that list is left as claque set it */
} clq_guard;

typedef enum clq_colour_format { CLQ_COLOUR_UBYTE = 0, CLQ_COLOUR_FLOAT = 1 } clq_colour_format;

/* The alpha test of zone keys. EQUAL is the papers' test; it is exact only where alpha keeps all its bits, and is for
 * CLQ_STRATEGY_PER_ZONE only. */
typedef enum clq_key_test { CLQ_KEY_GREATER_EQUAL = 0, CLQ_KEY_EQUAL = 1 } clq_key_test;

typedef void (*clq_gl_function)(void);

typedef struct clq_renderer_def {
    uint32_t struct_bytes; /* set by clq_renderer_def_init */
    /* Returns the address of a GL 1.1 function, or NULL. Required; called in clq_renderer_create. */
    clq_gl_function (*get_proc_address)(void *user, const char *name);
    void *user;
    clq_draw_strategy strategy;
    clq_guard guard;
    clq_colour_format colours;
    clq_key_test key_test;
    /* Batches: individuals at levels of at most this many triangles, with one part and one surface and without dirty
     * triangles, holes and vertex colours, are drawn several with one call. claque then moves their vertices to eye
     * space, which pays where a call costs more than its triangles. Positions may differ in the last bit, and so may
     * pixels on edges. More than 2730 act as 2730; 0: no batches. Default 128. */
    uint32_t batch_triangles;
    /* True: clean triangles are filtered GL_LINEAR where no sample mixes zones; all others stay GL_NEAREST. It costs
     * two draws per surface instead of one, a second texture, and a step in luminance between filtered and other
     * triangles: see clq_renderer_get_prepared. */
    bool linear_clean;
    /* Calls glFlush after about this many triangles, so that GL works on them while claque sends the rest. llvmpipe
     * rasterises on its own threads but not before a flush: 32768 takes about a quarter off a draw of ten thousand. Not
     * for contexts in which a flush shows or copies the picture (front buffers, OSMesa). 0 (default): never. */
    uint32_t flush_triangles;
    /* Of the levels in batches, those of at most this many triangles whose triangles each show one texel in one zone,
     * as proxies do (clq_levels_def.proxy_max_triangles), are drawn GL_FLAT and without a texture: each triangle has
     * the colour of its zone times its texel and is lit once by its normal. This needs less than half of the vertices;
     * drawing ten thousand people takes 0.87 of the time on llvmpipe. Actors with hooks are drawn like larger levels.
     * 0: never. Default 64. */
    uint32_t flat_triangles;
    /* Close textures: individuals near the eye get a texture of their own, in which claque multiplies the colours of
     * their zones on the CPU. It is filtered GL_LINEAR with a full mip chain, and drawn with one call per surface,
     * without dirty triangles, and without an alpha test but for holes. The member is the budget for all of them in
     * bytes of GL memory: four a texel, with all mip levels. 0 (default): off.
     * The nearest individuals of a view get one, up to the first that the budget has no room for. Others are drawn by
     * the strategy: those farther away than close_distance_m, in batches, with hooks, or with emission over a lit
     * colour; and those with a texture larger than the budget, or whose triangles come within half a texel of an edge
     * that clamps.
     * A draw makes what its view lacks before it draws anything, so the picture follows from the view alone and not
     * from earlier draws. Views that one renderer draws in turn share the budget; if together they want more, each draw
     * makes some textures anew. Individuals that show the same share one.
     * Light is limited to 1 before it meets the colours of zones, not after; specular light and the host's emission
     * take their colours. Keep it off where a picture is made of tiles, or compared with the strategies. */
    uint64_t close_texture_bytes;
    /* [m, >= 0] Individuals from this distance on show no close texture, for a picture of 768 lines over 60 degrees, as
     * distances of levels. 0 (default): measured for each template, see clq_prepared_info.close_distance_m. */
    float close_distance_m;
    /* Live hosts: the most textures that one draw makes, the nearest first; individuals wait for the others and are
     * drawn by the strategy meanwhile. The picture then depends on earlier draws. 0 (default): no limit. */
    uint32_t close_textures_per_draw;
    /* For targets with several samples a pixel. True: GL_MULTISAMPLE stays as the host has it, so that people have
     * smooth edges as all else in the picture. GL takes the texel at the centre of a pixel, which may lie beside a
     * triangle that covers the pixel in part; its share of the pixel may then have the shade of a texel beside it.
     * False (default): it is off, and the people's pixels are those of a target with one sample. It is off in either
     * case for shadows and visibility pictures. */
    bool multisample;
    /* From afar several texels fall on a pixel. GL_NEAREST shows one of them, another one in each frame, and pictures
     * in motion flicker. True: levels that begin so far away show images in which each texel is the mean of the
     * texels of its zone around it. Zones keep their borders to the pixel. It takes up to four more copies of each
     * texture in GL, and time in clq_renderer_prepare. Textures of hooks are shown as they are. False (default): all
     * levels show the template's images. */
    bool smooth_levels;
} clq_renderer_def;

static inline clq_renderer_def clq_renderer_def_init(void)
{
    clq_renderer_def def;
    memset(&def, 0, sizeof def);
    def.struct_bytes = (uint32_t)sizeof def;
    def.batch_triangles = 128;
    def.flat_triangles = 64;
    return def;
}

/* Creates a renderer for the current GL context.
 *   out   owned by the host until clq_renderer_destroy or clq_renderer_abandon
 * Fails: STRUCT_SIZE, ARGUMENT, GL_MISSING (no current context; the first missing function, by name), OUT_OF_MEMORY,
 * CALLBACK (get_proc_address threw an exception).
 * Threads: that of the current context. GL: queries only. */
CLQ_API clq_status clq_renderer_create(clq_context *context, const clq_renderer_def *def, clq_renderer **out);

/* Loads a template's textures into GL, before the first draw that shows it. Repeated calls do nothing. The renderer
 * holds the template until it is destroyed.
 * Fails: ARGUMENT (a template of another context), LIMIT (a texture too large for this GL), KEY_RESOLUTION (names the
 * zones), GL_STATE (names what would spoil the upload), GL_MISSING, OUT_OF_MEMORY (of GL too), BUSY. Threads: that of
 * the context that was current in clq_renderer_create, and with it current. GL: textures. */
CLQ_API clq_status clq_renderer_prepare(clq_renderer *renderer, clq_template *tmpl);

/* The result of preparing a template. */
typedef struct clq_prepared_info {
    uint32_t struct_bytes;      /* set by clq_prepared_info_init */
    clq_draw_strategy strategy; /* as requested; BINNED where one draw cannot tell the zones apart on this GL */
    /* Of the finest level; all 0 without linear_clean. */
    uint32_t triangle_count, linear_count; /* all triangles, and those that are filtered */
    uint32_t edge_count;                   /* edges between a filtered triangle and another one */
    float step_mean, step_max;             /* [0, 255] difference in luminance across these edges */
    /* [m] The renderer's, if it is given. Else it is where an individual that comes nearer changes by 2/255 in the mean
     * of its pixels when it gets a close texture, or by the least if that is more. This is measured when the template
     * is prepared: in its own colours and full light, for the textures of the levels that serve there. Farther away
     * GL_NEAREST skips ever more texels, and the two pictures differ ever more. 0: it shows no close textures. */
    float close_distance_m;
} clq_prepared_info;

CLQ_DEFINE_ZERO_INIT(clq_prepared_info)

/* Gets the result of preparing a template.
 *   out   made by clq_prepared_info_init
 * Fails: STRUCT_SIZE, ARGUMENT (also a template that is not prepared), BUSY. Threads: as clq_renderer_prepare.
 * GL: none. */
CLQ_API clq_status clq_renderer_get_prepared(const clq_renderer *renderer, const clq_template *tmpl,
                                             clq_prepared_info *out);

typedef struct clq_draw_stats {
    uint32_t struct_bytes; /* set by clq_draw_stats_init */
    uint32_t individuals;
    uint32_t draws;     /* calls of glDrawElements */
    uint32_t triangles; /* sent to GL, once per pass */
    uint64_t vertices;  /* sent to GL */
    uint32_t parts;     /* parts that were drawn, without those out of view (S0 4.2, phase 3) */
    uint32_t matrices;  /* calls of glMultMatrixf, see clq_rigid_mode */
    /* See clq_renderer_def.close_texture_bytes. */
    uint32_t close_individuals;   /* drawn with textures of their own */
    uint32_t close_textures_made; /* by this draw */
    uint64_t close_texture_bytes; /* of GL memory held, [<= the budget] */
} clq_draw_stats;

CLQ_DEFINE_ZERO_INIT(clq_draw_stats)

/* Draws a view's draw list as the last update left it. The crowd does not change: several views of it may be drawn at
 * once, each by a renderer and a thread of its own. An update fails with BUSY during a draw, and a draw during an
 * update.
 *   out_stats   made by clq_draw_stats_init; may be NULL
 * Fails before drawing anything: STRUCT_SIZE, ARGUMENT (a template that is not prepared, by name; a view of another
 * context), GL_STATE (names what would spoil the picture), GL_MISSING, BUSY, OUT_OF_MEMORY (for choosing close
 * textures). Fails after drawing the rest: OUT_OF_MEMORY (the update left individuals out, see
 * clq_crowd_stats.left_out; GL has no memory for close textures, and their individuals are drawn by the strategy),
 * GL_STATE (what hooks leave, see above), CALLBACK (a hook threw an exception). Fails after drawing a part: GL_MISSING
 * (the context was lost meanwhile, see clq_renderer_abandon). Threads: as clq_renderer_prepare. GL: see above. */
CLQ_API clq_status clq_renderer_draw(clq_renderer *renderer, clq_view *view, clq_draw_stats *out_stats);

/* Destroys a renderer while its GL context is current; NULL is ignored. Fails: BUSY (it is drawing, and a hook calls
 * this); the renderer then stays. Threads: as clq_renderer_prepare. GL: deletes its textures. */
CLQ_API clq_status clq_renderer_destroy(clq_renderer *renderer);

/* Destroys a renderer whose GL context is lost, without GL calls; NULL is ignored. Another renderer may draw the same
 * crowd at once. Fails: BUSY, as clq_renderer_destroy. Threads: any, while no other call uses the renderer.
 * GL: none. */
CLQ_API clq_status clq_renderer_abandon(clq_renderer *renderer);

#ifdef __cplusplus
}
#endif

#endif
