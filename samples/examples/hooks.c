/* Drawing in GL: callbacks around the drawing of one actor, the result of preparing a template, and how a host goes on
 * after its GL context is lost. Exits with 77 without OpenGL. */
#include <claque/assets.h>

#include <string.h>

#include "samples/examples/check.h"
#include "samples/examples/offscreen.h"

enum { SIZE = 128, DEPTH_AND_COLOUR = 0x4100 };

static unsigned char pixels[4 * SIZE * SIZE];
static offscreen screen;

typedef struct counts {
    uint32_t before, after;
    clq_actor last;
} counts;

static void (*colour_mask)(unsigned char, unsigned char, unsigned char, unsigned char);

/* Draws only the red of its actor, and binds no texture. */
static bool before(void *user, clq_actor actor)
{
    counts *seen = user;
    ++seen->before, seen->last = actor;
    colour_mask(1, 0, 0, 1);
    return false;
}

static void after(void *user, clq_actor actor) { ((counts *)user)->after += actor.index1 > 0; }

/* Makes a GL context and a renderer for it, which knows the template. */
static void new_context(clq_context *context, clq_template *tmpl, clq_renderer **renderer)
{
    const int failed = offscreen_open(&screen, SIZE, SIZE, pixels);
    if (failed) exit(failed);
    {
        clq_gl_function found = offscreen_function(NULL, "glColorMask");
        memcpy(&colour_mask, &found, sizeof found);
    }
    clq_renderer_def def = clq_renderer_def_init();
    def.get_proc_address = offscreen_function, def.linear_clean = true;
    check(clq_renderer_create(context, &def, renderer));
    clq_prepared_info prepared = clq_prepared_info_init();
    expect(clq_renderer_get_prepared(*renderer, tmpl, &prepared) == CLQ_ARGUMENT, "nothing is prepared yet");
    check(clq_renderer_prepare(*renderer, tmpl));
    check(clq_renderer_get_prepared(*renderer, tmpl, &prepared));
    expect(prepared.linear_count > 0 && prepared.linear_count <= prepared.triangle_count, "some are filtered");
}

/* Draws, and counts the pixels that are green. */
static uint32_t draw(clq_renderer *renderer, clq_view *view)
{
    uint32_t green = 0;
    clq_draw_stats stats = clq_draw_stats_init();
    ((void (*)(unsigned))offscreen_function(NULL, "glClear"))(DEPTH_AND_COLOUR);
    check(clq_renderer_draw(renderer, view, &stats));
    offscreen_finish(&screen);
    expect(stats.individuals == 1 && stats.draws > 0, "the actor is drawn");
    for (int i = 0; i < SIZE * SIZE; ++i) green += pixels[4 * i + 1] > 0;
    return green;
}

int main(void)
{
    clq_context *context;
    clq_template *citizen;
    clq_crowd *crowd;
    clq_view *view;
    clq_actor actor;
    clq_renderer *renderer;
    check(clq_context_create(NULL, &context));
    check(clq_template_builtin(context, "citizen", &citizen));
    check(clq_crowd_create(context, NULL, &crowd));
    clq_actor_def def = clq_actor_def_init();
    def.tmpl = citizen, def.play.clip = clq_template_find_clip(citizen, "stand");
    check(clq_actor_create(crowd, &def, &actor));
    check(clq_view_create(crowd, &view));
    clq_look_at_def look = clq_look_at_def_init();
    clq_camera camera;
    look.eye[1] = look.target[1] = 0.9, look.eye[2] = 2.5;
    check(clq_camera_look_at(&look, &camera));
    check(clq_view_set_camera(view, &camera));
    check(clq_crowd_update(crowd, 1.0, &view, 1));

    new_context(context, citizen, &renderer);
    const uint32_t plain = draw(renderer, view);
    expect(plain > 100, "without hooks the actor has green in its colours");
    counts seen = {0};
    const clq_actor_hooks hooks = {before, after, &seen};
    check(clq_actor_set_hooks(crowd, actor, &hooks));
    check(clq_crowd_update(crowd, 1.0, &view, 1));
    expect(draw(renderer, view) == 0, "the hook's mask keeps green out");
    expect(seen.before == seen.after && seen.before > 0 && seen.last.index1 == actor.index1, "both hooks were called");
    check(clq_actor_set_hooks(crowd, actor, NULL));
    check(clq_crowd_update(crowd, 1.0, &view, 1));
    expect(draw(renderer, view) == plain, "without hooks the picture is as before");

    offscreen_close(&screen); /* as when a window system takes the context away */
    clq_renderer_abandon(renderer);
    new_context(context, citizen, &renderer);
    expect(draw(renderer, view) == plain, "a new renderer draws the same picture in another context");
    clq_renderer_destroy(renderer);
    offscreen_close(&screen);
    clq_crowd_destroy(crowd);
    clq_template_destroy(citizen);
    check(clq_context_destroy(context));
    return printf("%u pixels with green, none of them through the hook\n", plain) < 0;
}
