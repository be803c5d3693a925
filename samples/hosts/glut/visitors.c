#include "samples/hosts/glut/visitors.h"

#include <claque/assets.h>

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "samples/hosts/glut/paint.h"

enum { LISTENERS = 70, PLAYERS = 6, WALKERS = 18, VISITORS = LISTENERS + PLAYERS + WALKERS, TEMPLATES = 4, GUARDS = 3 };

static clq_context *context;
static clq_template *templates[TEMPLATES];
static clq_crowd *crowd;
static clq_view *view;
static clq_renderer *renderers[GUARDS]; /* by clq_guard */
static clq_actor actors[VISITORS];
static clq_transform places[VISITORS];
static clq_draw_stats last;

static void check(clq_status status)
{
    if (status == CLQ_OK) return;
    fprintf(stderr, "claque: %s: %s\n", clq_status_name(status), clq_last_error());
    exit(1);
}

/* Standing at (x, z) on ground y and facing along (dx, dz); characters face +z. */
static clq_transform stand(float x, float y, float z, float dx, float dz)
{
    clq_transform transform = {{x, y, z}, {0, 0, 0, 1}, 1};
    const float half = 0.5f * atan2f(dx, dz);
    transform.orientation_xyzw[1] = sinf(half), transform.orientation_xyzw[3] = cosf(half);
    return transform;
}

static void enter(int person, clq_transform transform, const char *clip)
{
    clq_actor_def def = clq_actor_def_init();
    def.tmpl = templates[(int)(TEMPLATES * paint_random((unsigned)person, 0, 40))];
    def.transform = places[person] = transform;
    def.play.clip = clq_template_find_clip(def.tmpl, clip);
    def.play.phase_s = 5 * paint_random((unsigned)person, 1, 40);
    def.seed = (uint64_t)person;
    check(clq_actor_create(crowd, &def, &actors[person]));
    check(clq_actor_randomise_colours(crowd, actors[person], NULL, 0));
}

/* Arcs before the bandstand, which faces the eye, with a path left open between them. */
static void enter_listeners(void)
{
    static const char *const clips[] = {"stand_applaud", "stand", "applaud", "stand_wave", "stand_laugh", "stand"};
    for (int person = 0; person < LISTENERS; ++person) {
        const int row = person / 14, side = person % 14 < 7 ? -1 : 1;
        const unsigned number = (unsigned)person;
        const float radius = 6.2f + 1.1f * (float)row + 0.3f * paint_random(number, 2, 40);
        const float turn =
            (float)side *
            ((2.4f + 1.15f * ((float)(person % 7) + 0.5f * (float)(row % 2)) + 0.3f * paint_random(number, 3, 40)) /
             radius);
        const float x = radius * sinf(turn), z = radius * cosf(turn);
        enter(person, stand(x, 0, z - 12, -x, -z), clips[(int)(6 * paint_random(number, 4, 40))]);
    }
}

static void enter_players(void)
{
    static const char *const clips[] = {"cheer", "stand_wave", "applaud"};
    for (int i = 0; i < PLAYERS; ++i) {
        const float turn = 0.42f * ((float)i - 2.5f), r = 2.6f;
        enter(LISTENERS + i, stand(r * sinf(turn), PARK_BANDSTAND_FLOOR, r * cosf(turn) - 12, sinf(turn), cosf(turn)),
              clips[i % 3]);
    }
}

static const float walking_speed = 1.15f; /* metres a second */

/* Up and down the path forever: a function of time. */
static clq_transform walk(int walker, double time_s)
{
    const float speed = walking_speed, length = 30;
    const float way = walker % 2 ? 1.0f : -1.0f;
    const float start = length * ((float)walker + 0.6f * paint_random((unsigned)walker, 5, 40)) / WALKERS;
    const float along = fmodf(start + (float)fmod(time_s * speed, length), length);
    const float x = way * (0.45f + 1.7f * paint_random((unsigned)walker, 6, 40));
    return stand(x, 0, way > 0 ? 8 - along : along - 22, 0, -way);
}

void visitors_create(clq_gl_function (*get_proc_address)(void *user, const char *name))
{
    static const char *const names[TEMPLATES] = {"citizen", "patrician", "decurion", "plebeian"};
    check(clq_context_create(NULL, &context));
    for (int i = 0; i < TEMPLATES; ++i) check(clq_template_builtin(context, names[i], &templates[i]));
    check(clq_crowd_create(context, NULL, &crowd));
    check(clq_view_create(crowd, &view));
    for (int guard = 0; guard < GUARDS; ++guard) {
        clq_renderer_def def = clq_renderer_def_init();
        def.get_proc_address = get_proc_address;
        def.guard = (clq_guard)guard;
        check(clq_renderer_create(context, &def, &renderers[guard]));
        for (int i = 0; i < TEMPLATES; ++i) check(clq_renderer_prepare(renderers[guard], templates[i]));
    }
    enter_listeners();
    enter_players();
    for (int i = 0; i < WALKERS; ++i) {
        const int person = LISTENERS + PLAYERS + i;
        enter(person, walk(i, 0), "walk");
        check(clq_crowd_set_speeds(crowd, &actors[person], &walking_speed, 1)); /* claque sees places, not speeds */
    }
}

void visitors_draw(const park_eye *eye, double time_s, clq_guard guard)
{
    clq_look_at_def look = clq_look_at_def_init();
    clq_camera camera;
    const int first = LISTENERS + PLAYERS;
    for (int i = 0; i < WALKERS; ++i) places[first + i] = walk(i, time_s);
    check(clq_crowd_set_transforms(crowd, actors + first, places + first, WALKERS));
    for (int k = 0; k < 3; ++k) look.eye[k] = eye->at[k], look.target[k] = eye->target[k];
    look.fov_y_rad = (float)(eye->fov_y_deg * 3.14159265358979 / 180);
    look.aspect = (float)eye->aspect;
    look.z_near = (float)eye->z_near, look.z_far = (float)eye->z_far;
    check(clq_camera_look_at(&look, &camera));
    check(clq_view_set_camera(view, &camera));
    check(clq_crowd_update(crowd, time_s, &view, 1));
    last = clq_draw_stats_init();
    check(clq_renderer_draw(renderers[guard], view, &last));
}

void visitors_destroy(void)
{
    for (int guard = 0; guard < GUARDS; ++guard) clq_renderer_destroy(renderers[guard]);
    clq_crowd_destroy(crowd);
    for (int i = 0; i < TEMPLATES; ++i) clq_template_destroy(templates[i]);
    check(clq_context_destroy(context));
}

int visitors_count(void) { return VISITORS; }

int visitors_at(int person, float *x, float *z)
{
    clq_actor_info info = clq_actor_info_init();
    *x = (float)places[person].position[0], *z = (float)places[person].position[2];
    return clq_actor_get_info(crowd, actors[person], &info) == CLQ_OK && info.visible;
}

clq_draw_stats visitors_stats(void) { return last; }
