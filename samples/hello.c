/* A crowd in fifty lines: a hundred citizens applaud in a GL 1.1 context without a window; the picture is hello.ppm.
 * Your own program has a context already: copy only the part between the two rulers. */
#include <claque/assets.h>
#include <claque/claque.h>

#include <stdio.h>
#include <stdlib.h>

#include "samples/examples/offscreen.h"

enum { WIDTH = 640, HEIGHT = 480, DEPTH_AND_COLOUR = 0x4100 };

static void check(clq_status status)
{
    if (status == CLQ_OK) return;
    fprintf(stderr, "%s: %s\n", clq_status_name(status), clq_last_error());
    exit(1);
}

int main(void)
{
    static unsigned char pixels[4 * WIDTH * HEIGHT];
    offscreen screen;
    const int failed = offscreen_open(&screen, WIDTH, HEIGHT, pixels);
    if (failed) return failed;
    void (*clear_colour)(float, float, float, float) =
        (void (*)(float, float, float, float))offscreen_function(NULL, "glClearColor");
    void (*clear)(unsigned) = (void (*)(unsigned))offscreen_function(NULL, "glClear");

    /* ---------------------------------------------------------------- claque: make a crowd */
    clq_context *context;
    clq_template *citizen;
    clq_crowd *crowd;
    clq_view *view;
    clq_renderer *renderer;
    check(clq_context_create(NULL, &context));
    check(clq_template_builtin(context, "citizen", &citizen)); /* or clq_template_load_gltf with your own bytes */
    check(clq_crowd_create(context, NULL, &crowd));
    for (int i = 0; i < 100; ++i) {
        clq_actor actor;
        clq_actor_def def = clq_actor_def_init();
        def.tmpl = citizen;
        def.transform.position[0] = (i % 10 - 4.5) * 0.9 + (i / 10 % 2) * 0.45; /* metres; y is up */
        def.transform.position[2] = -(i / 10) * 0.9;
        def.play.clip = clq_template_find_clip(citizen, i % 4 == 0 ? "cheer" : "applaud");
        def.play.phase_s = (float)(i * 7 % 13) * 0.15f;
        def.seed = (uint64_t)i;
        check(clq_actor_create(crowd, &def, &actor));
        check(clq_actor_randomise_colours(crowd, actor, NULL, 0));
    }
    /* ---------------------------------------------------------------- and draw a frame at 2.5 s */
    clq_renderer_def renderer_def = clq_renderer_def_init();
    renderer_def.get_proc_address = offscreen_function;
    check(clq_renderer_create(context, &renderer_def, &renderer));
    check(clq_renderer_prepare(renderer, citizen));
    check(clq_view_create(crowd, &view));
    clq_camera camera;
    clq_look_at_def look = clq_look_at_def_init();
    look.eye[1] = 2.9, look.eye[2] = 4.2;
    look.target[1] = 0.7, look.target[2] = -2.5;
    look.fov_y_rad = 0.75f, look.z_far = 100.0f;
    check(clq_camera_look_at(&look, &camera));
    check(clq_view_set_camera(view, &camera));
    check(clq_crowd_update(crowd, 2.5, &view, 1));
    clear_colour(0.72f, 0.66f, 0.56f, 1), clear(DEPTH_AND_COLOUR);
    check(clq_renderer_draw(renderer, view, NULL));
    offscreen_finish(&screen);
    /* ---------------------------------------------------------------- */

    FILE *file = fopen("hello.ppm", "wb");
    if (!file) return perror("hello.ppm"), 1;
    fprintf(file, "P6 %d %d 255\n", WIDTH, HEIGHT);
    for (int y = HEIGHT - 1; y >= 0; --y)
        for (int x = 0; x < WIDTH; ++x) fwrite(pixels + 4 * (y * WIDTH + x), 1, 3, file);
    fclose(file);
    clq_renderer_destroy(renderer);
    offscreen_close(&screen);
    clq_template_destroy(citizen);
    clq_crowd_destroy(crowd);
    check(clq_context_destroy(context));
    return puts("hello.ppm") < 0;
}
