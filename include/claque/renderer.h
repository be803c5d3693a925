/* clq_renderer: draw lists to pixels, with GL 1.1 only. One per GL context.
 *
 * claque links no GL: it asks the host for the functions it uses (all of OpenGL 1.1) once, at creation. It inherits the
 * host's viewport, scissor, lights, fog, clip planes, stencil and shade model (but see flat_triangles), and sets what its
 * picture depends on:
 * blending off, alpha test, depth test GL_LEQUAL with writes, alpha writes masked, face culling, one texture with
 * GL_MODULATE, no texture generation, identity texture matrix, colour material on ambient and diffuse, GL_NORMALIZE,
 * its own matrices.
 *
 * Hooks (clq_actor_set_hooks) are called round the drawing of their actor; not where it is not drawn. They find the
 * view's projection, the actor's own model-view matrix, GL_MODELVIEW as the matrix mode, all client arrays off and
 * texture 0 bound, so that claque's textures are out of their reach. All attributes are pushed round the two. What
 * before() sets of what claque inherits (above; materials and the RGB mask too) acts on this actor, and is gone after
 * after(); what claque sets itself it sets anew after each. What one pushes on a stack the other may pop; what is left
 * over is popped, an open display list, selection or feedback ended. Neither pops what it has not pushed. A texture
 * bound by before() that is to be used is sampled as it stands: GL_NEAREST in both filters and no mipmaps, or keys mix;
 * its alpha holds the zone keys of the template's. What GL keeps in no attribute group, such as pixel maps, stays. A
 * program, buffer or other thing newer than GL 1.1 that before() leaves in use keeps its actor from being drawn, one
 * that is still in use after after() all that come later; the draw then fails with GL_STATE and their names. */
#ifndef CLAQUE_RENDERER_H
#define CLAQUE_RENDERER_H

#include <claque/view.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef struct clq_renderer clq_renderer;

/* How individuals get their colours. All three give the same RGB and depth. */
typedef enum clq_draw_strategy {
    CLQ_STRATEGY_FUSED = 0,   /* everything in one draw a surface */
    CLQ_STRATEGY_BINNED = 1,  /* dirty triangles only in the passes of zones that they touch */
    CLQ_STRATEGY_PER_ZONE = 2 /* S1 3, S2 2.1: one draw a clean bin, all dirty triangles once per zone */
} clq_draw_strategy;

/* What is left of the host's GL state after a draw. */
typedef enum clq_guard {
    CLQ_GUARD_FULL = 0,    /* everything as it was */
    CLQ_GUARD_MINIMAL = 1, /* matrices and client state as they were; the documented list of passes/guard.h is left */
    CLQ_GUARD_NONE = 2     /* everything in the documented list is left as claque set it */
} clq_guard;

typedef enum clq_colour_format { CLQ_COLOUR_UBYTE = 0, CLQ_COLOUR_FLOAT = 1 } clq_colour_format;

/* GL_EQUAL is the papers' test; it is sound only where alpha keeps all its bits. Per-zone only. */
typedef enum clq_key_test { CLQ_KEY_GREATER_EQUAL = 0, CLQ_KEY_EQUAL = 1 } clq_key_test;

typedef void (*clq_gl_function)(void);

typedef struct clq_renderer_def {
    uint32_t struct_bytes;                                             /* set by clq_renderer_def_init */
    clq_gl_function (*get_proc_address)(void *user, const char *name); /* required; asked for GL 1.1 names only */
    void *user;
    clq_draw_strategy strategy;
    clq_guard guard;
    clq_colour_format colours;
    clq_key_test key_test;
    /* Individuals at levels of so many triangles and fewer, of one surface without dirty triangles, are drawn several
       with one call, their vertices moved to eye space by claque: where a call costs more than what it draws (default
       128, most 2730; 0: never). Which way decides about the last bit of a position, so pixels on edges may differ. */
    uint32_t batch_triangles;
    /* 1: clean triangles are filtered GL_LINEAR, those that can be without a sample that mixes zones; everything else stays
       GL_NEAREST. Two draws a surface instead of one, a second texture, and a step in luminance where a filtered triangle
       meets one that is not: see clq_renderer_get_prepared. Default 0 */
    int32_t linear_clean;
    /* glFlush after about so many triangles, so that GL works on them while claque sends the rest. llvmpipe rasterises on
       threads of its own, but not before a flush: 32768 takes about a quarter off a draw of ten thousand. Not for
       contexts in which a flush shows or copies the picture: front buffers, OSMesa. Nothing else changes. 0 (default): never */
    uint32_t flush_triangles;
    /* Of the levels that batch_triangles is for, those of so many triangles and fewer whose triangles each show one texel
       in one zone, as far ones do (clq_levels_def.proxy_max_triangles), are drawn GL_FLAT and without a texture: a triangle in the
       colour of its zone times its texel, lit once, as it faces. Less than half of the vertices; drawing ten thousand people
       takes 0.87 of the time on llvmpipe. Whoever has hooks is drawn as larger levels are. Default 64; 0: never */
    uint32_t flat_triangles;
} clq_renderer_def;

static inline clq_renderer_def clq_renderer_def_init(void)
{
    clq_renderer_def def;
    def.struct_bytes = (uint32_t)sizeof def;
    def.get_proc_address = NULL;
    def.user = NULL;
    def.strategy = CLQ_STRATEGY_FUSED;
    def.guard = CLQ_GUARD_FULL;
    def.colours = CLQ_COLOUR_UBYTE;
    def.key_test = CLQ_KEY_GREATER_EQUAL;
    def.batch_triangles = 128;
    def.linear_clean = 0;
    def.flush_triangles = 0;
    def.flat_triangles = 64;
    return def;
}

/* Makes a renderer for the current GL context. out: [owner: host]
 * Fails: STRUCT_SIZE, ARGUMENT, GL_MISSING (no current context; first missing function by name), OUT_OF_MEMORY.
 * Threads: the one whose context is current, here and below. GL: queries only. */
CLQ_API clq_status clq_renderer_create(clq_context *context, const clq_renderer_def *def, clq_renderer **out);

/* Brings a template's textures to GL; once per template, before the first draw that shows it. Again is harmless.
 * The template is held until the renderer goes.
 * Fails: ARGUMENT (a template of another context), LIMIT (texture too large for this GL), KEY_RESOLUTION (names the
 * zones), GL_STATE (what would spoil the upload, by name), GL_MISSING, OUT_OF_MEMORY; nothing is changed then. */
CLQ_API clq_status clq_renderer_prepare(clq_renderer *renderer, clq_template *tmpl);

/* What became of a template that was prepared. */
typedef struct clq_prepared_info {
    clq_draw_strategy strategy; /* as asked for, or BINNED where one draw cannot tell its zones apart on this GL */
    /* Of the finest level, all 0 without linear_clean: */
    uint32_t triangle_count, linear_count; /* of which so many are filtered */
    uint32_t edge_count;                   /* between a triangle that is filtered and one that is not */
    float step_mean, step_max;             /* [0, 255] difference in luminance between the two ways along these edges */
} clq_prepared_info;

/* Fails: ARGUMENT (also for a template that is not prepared). GL: none. */
CLQ_API clq_status clq_renderer_get_prepared(const clq_renderer *renderer, const clq_template *tmpl,
                                             clq_prepared_info *out);

typedef struct clq_draw_stats {
    uint32_t individuals;
    uint32_t draws;     /* glDrawElements calls */
    uint32_t triangles; /* sent to GL, each pass counted */
    uint64_t vertices;  /* sent to GL */
    uint32_t parts;     /* of individuals, that were drawn: those out of view are left out (S0 4.2, phase 3) */
    uint32_t matrices;  /* glMultMatrixf calls, see clq_rigid_mode */
} clq_draw_stats;

/* Draws a view's list as the last update left it. The crowd is not changed: several views of it may be drawn at once, each
 * by a renderer and a thread of its own. While it is drawn an update is BUSY, and while it is updated a draw is.
 *   out_stats   may be NULL
 * Fails: ARGUMENT (a template that is not prepared, by name), GL_STATE (what would spoil the picture, by name),
 * GL_MISSING, BUSY; nothing is drawn or changed then. OUT_OF_MEMORY: somebody whom no cache holds found no room to be
 * skinned in; all others are drawn. GL_STATE also for what hooks leave, see above. */
CLQ_API clq_status clq_renderer_draw(clq_renderer *renderer, clq_view *view, clq_draw_stats *out_stats);

/* Ends a renderer, its context being current; NULL is ignored. */
CLQ_API void clq_renderer_destroy(clq_renderer *renderer);

/* Ends a renderer whose context is lost: no GL call is made. Another may be made from the same crowd at once. */
CLQ_API void clq_renderer_abandon(clq_renderer *renderer);

#ifdef __cplusplus
}
#endif

#endif
