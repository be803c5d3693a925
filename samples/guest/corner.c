#include "samples/guest/corner.h"

#include <claque/assets.h>

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { PEOPLE = 40, ROW = 8 };
enum {
    GL_DEPTH_AND_COLOUR_BUFFER_BITS = 0x4100,
    GL_ENABLE_LIGHTING_SCISSOR_BITS = 0x82040,
    GL_TRANSFORM_VIEWPORT_BITS = 0x1800,
    GL_DEPTH_BUFFER_BIT = 0x100,
    GL_BACK = 0x405,
    GL_MODELVIEW = 0x1700,
    GL_SCISSOR_TEST = 0xC11,
    GL_STENCIL_TEST = 0xB90,
    GL_FOG = 0xB60,
    GL_LIGHTING = 0xB50,
    GL_SMOOTH = 0x1D01,
    GL_LIGHT0 = 0x4000,
    GL_CLIP_PLANE0 = 0x3000,
    GL_POSITION = 0x1203,
    GL_DIFFUSE = 0x1201,
    GL_SPECULAR = 0x1202,
    GL_AMBIENT = 0x1200,
    GL_EMISSION = 0x1600,
    GL_FRONT_AND_BACK = 0x408,
    GL_LIGHT_MODEL_AMBIENT = 0xB53
};

/* The functions of GL that this host calls itself. */
static struct {
    void (*PushAttrib)(unsigned);
    void (*PopAttrib)(void);
    void (*Enable)(unsigned), (*Disable)(unsigned), (*DrawBuffer)(unsigned), (*ShadeModel)(unsigned);
    void (*Viewport)(int, int, int, int), (*Scissor)(int, int, int, int);
    void (*ColorMask)(unsigned char, unsigned char, unsigned char, unsigned char);
    void (*DepthMask)(unsigned char);
    void (*DepthRange)(double, double), (*ClearDepth)(double);
    void (*Clear)(unsigned);
    void (*MatrixMode)(unsigned);
    void (*PushMatrix)(void), (*PopMatrix)(void), (*LoadIdentity)(void);
    void (*Lightfv)(unsigned, unsigned, const float *), (*Materialfv)(unsigned, unsigned, const float *);
    void (*LightModelfv)(unsigned, const float *);
} gl;

static clq_context *library;
static clq_template *citizen;
static clq_crowd *crowd;
static clq_view *view;
static clq_renderer *renderer;
static int width = 320, height = 240, failed;
static unsigned long frame;

static int ok(clq_status status)
{
    if (status == CLQ_OK) return 1;
    if (!failed) fprintf(stderr, "claque guest: %s: %s\n", clq_status_name(status), clq_last_error());
    failed = 1;
    return 0;
}

static int make_crowd(void)
{
    const char *const size = getenv("CLAQUE_GUEST");
    static const char *const clips[] = {"stand_applaud", "stand_wave", "cheer", "stand", "applaud"};
    clq_look_at_def look = clq_look_at_def_init();
    clq_camera camera;
    if (size && (sscanf(size, "%dx%d", &width, &height) != 2 || width < 1 || height < 1)) {
        fprintf(stderr, "claque guest: CLAQUE_GUEST is '%s'; it must be WIDTHxHEIGHT in pixels\n", size);
        return 0;
    }
    if (!ok(clq_context_create(NULL, &library)) || !ok(clq_template_builtin(library, "citizen", &citizen)) ||
        !ok(clq_crowd_create(library, NULL, &crowd)) || !ok(clq_view_create(crowd, &view)))
        return 0;
    for (int i = 0; i < PEOPLE; ++i) {
        clq_actor actor;
        clq_actor_def def = clq_actor_def_init();
        const int row = i / ROW;
        def.tmpl = citizen;
        def.transform.position[0] = (i % ROW - (ROW - 1) / 2.0) * 0.9 + (row % 2) * 0.45;
        def.transform.position[2] = -row;
        def.play.clip = clq_template_find_clip(citizen, clips[i * 7 % 5]);
        def.play.phase_s = (float)(i * 7 % 13) * 0.3f;
        def.seed = (uint64_t)i;
        if (!ok(clq_actor_create(crowd, &def, &actor)) || !ok(clq_actor_randomise_colours(crowd, actor, NULL, 0)))
            return 0;
    }
    look.eye[1] = 3.2, look.eye[2] = 6.5, look.target[1] = 0.9, look.target[2] = -1.6;
    look.fov_y_rad = 0.56f, look.aspect = (float)width / (float)height, look.z_far = 50;
    return ok(clq_camera_look_at(&look, &camera)) && ok(clq_view_set_camera(view, &camera)) &&
           ok(clq_view_set_height(view, (float)height));
}

static int make_renderer(clq_gl_function (*get_proc_address)(void *user, const char *name))
{
    const char *const guard = getenv("CLAQUE_GUEST_GUARD");
    clq_renderer_def def = clq_renderer_def_init();
#define FIND(name) gl.name = (__typeof__(gl.name))get_proc_address(NULL, "gl" #name)
    FIND(PushAttrib), FIND(PopAttrib), FIND(Enable), FIND(Disable), FIND(DrawBuffer), FIND(ShadeModel), FIND(Viewport);
    FIND(Scissor), FIND(ColorMask), FIND(DepthMask), FIND(DepthRange), FIND(ClearDepth), FIND(Clear), FIND(MatrixMode);
    FIND(PushMatrix), FIND(PopMatrix), FIND(LoadIdentity), FIND(Lightfv), FIND(Materialfv), FIND(LightModelfv);
    def.get_proc_address = get_proc_address;
    if (guard && !strcmp(guard, "minimal")) def.guard = CLQ_GUARD_MINIMAL;
    if (guard && !strcmp(guard, "none")) def.guard = CLQ_GUARD_NONE;
    return ok(clq_renderer_create(library, &def, &renderer)) && ok(clq_renderer_prepare(renderer, citizen));
}

/* What claque inherits from its host: the corner alone, one lamp, no fog. */
static void set_the_scene(void)
{
    static const float lamp[] = {0.4f, 0.6f, 1, 0}, bright[] = {0.85f, 0.85f, 0.85f, 1},
                       dim[] = {0.35f, 0.35f, 0.35f, 1};
    static const float none[] = {0, 0, 0, 1};
    gl.DrawBuffer(GL_BACK), gl.ColorMask(1, 1, 1, 1), gl.ShadeModel(GL_SMOOTH);
    gl.Disable(GL_FOG), gl.Disable(GL_STENCIL_TEST);
    for (unsigned i = 0; i < 6; ++i) gl.Disable(GL_CLIP_PLANE0 + i);
    for (unsigned i = 1; i < 8; ++i) gl.Disable(GL_LIGHT0 + i);
    gl.Viewport(0, 0, width, height), gl.Scissor(0, 0, width, height), gl.Enable(GL_SCISSOR_TEST);
    gl.MatrixMode(GL_MODELVIEW), gl.PushMatrix(), gl.LoadIdentity();
    gl.Lightfv(GL_LIGHT0, GL_POSITION, lamp), gl.Lightfv(GL_LIGHT0, GL_DIFFUSE, bright);
    gl.Lightfv(GL_LIGHT0, GL_AMBIENT, none), gl.Lightfv(GL_LIGHT0, GL_SPECULAR, none);
    gl.PopMatrix();
    gl.LightModelfv(GL_LIGHT_MODEL_AMBIENT, dim), gl.Materialfv(GL_FRONT_AND_BACK, GL_EMISSION, none);
    gl.Enable(GL_LIGHT0), gl.Enable(GL_LIGHTING);
    gl.DepthRange(0, 1), gl.ClearDepth(1), gl.DepthMask(1), gl.Clear(GL_DEPTH_BUFFER_BIT);
}

void corner_draw(const void *context, clq_gl_function (*get_proc_address)(void *user, const char *name))
{
    static const void *first;
    if (!first) first = context;
    if (failed || context != first) return;
    if (!crowd && !make_crowd()) {
        failed = 1;
        return;
    }
    if (!renderer && !make_renderer(get_proc_address)) return;
    if (!ok(clq_crowd_update(crowd, (double)frame++ / 60, &view, 1))) return;
    /* What set_the_scene sets; what claque sets is for the guard. */
    gl.PushAttrib(GL_DEPTH_AND_COLOUR_BUFFER_BITS | GL_ENABLE_LIGHTING_SCISSOR_BITS | GL_TRANSFORM_VIEWPORT_BITS);
    set_the_scene();
    ok(clq_renderer_draw(renderer, view, NULL));
    gl.PopAttrib();
}
