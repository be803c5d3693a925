/* A square full of people is searched: the neighbours of a point, those in a category, those whom a camera
 * sees, the order of the host's own, and the person under the mouse. Answers follow people as they move. */
#include <claque/assets.h>

#include <math.h>

#include "samples/examples/check.h"

enum { side = 20, count = side * side, seated = 1 };

static clq_actor people[count];
static double keys[count];
static clq_scene_hit hits[count];
static clq_actor found[count];

/* Rows of people, one to a square metre; every fourth row is seated. */
static clq_scene *fill(clq_crowd *crowd, clq_template *citizen)
{
    clq_scene *scene;
    check(clq_scene_create(crowd, &scene));
    for (int i = 0; i < count; ++i) {
        clq_actor_def def = clq_actor_def_init();
        def.tmpl = citizen;
        def.transform.position[0] = i % side, def.transform.position[2] = -(i / side);
        check(clq_actor_create(crowd, &def, &people[i]));
        keys[i] = count - i; /* for example a number in a queue */
    }
    for (int i = 0; i < count; i += 4 * side) check(clq_scene_set_categories(scene, people + i, side, 1u << seated));
    check(clq_scene_set_keys(scene, people, keys, count));
    return scene;
}

static void ask_for_places(const clq_scene *scene)
{
    const double point[3] = {5.2, 0, -6.1}, low[3] = {0, -1, -3}, high[3] = {2, 1, 0};
    uint32_t got;
    check(clq_scene_find_nearest(scene, 0, point, INFINITY, NULL, hits, 3, &got));
    expect(got == 3 && hits[0].actor.index1 == people[6 * side + 5].index1, "the nearest one stands at (5, 6)");
    check(clq_scene_find_within(scene, 0, point, 2, NULL, NULL, 0, &got));
    expect(got == 11, "eleven people are within two metres");
    check(clq_scene_find_in_box(scene, 0, low, high, NULL, hits, count, &got));
    expect(got == 12 && hits[0].actor.index1 == people[0].index1, "a box holds three columns of four");
}

static void ask_for_categories(const clq_scene *scene)
{
    clq_scene_filter filter = clq_scene_filter_init();
    clq_actor next;
    uint32_t got;
    filter.all_of = 1u << seated;
    check(clq_scene_find(scene, &filter, found, count, &got));
    expect(got == 5 * side && found[side].index1 == people[4 * side].index1, "five rows are seated");
    check(clq_scene_find_keys(scene, 1, 10, NULL, found, count, &got));
    expect(got == 10 && found[0].index1 == people[count - 1].index1, "the queue begins with the last one made");
    check(clq_scene_find_next(scene, found[0], false, &filter, &next));
    expect(next.index1 == people[17 * side - 1].index1, "row 16 is the last one seated");
}

/* The camera looks down the middle column from two metres before the first row. */
static void ask_for_the_picture(clq_crowd *crowd, clq_scene *scene, const clq_template *citizen)
{
    clq_view *view;
    clq_camera camera;
    clq_ray ray;
    uint32_t got, of_level, shown = 0;
    clq_scene_pick pick = clq_scene_pick_init();
    clq_scene_filter filter = clq_scene_filter_init();
    clq_look_at_def look = clq_look_at_def_init();
    look.eye[0] = look.target[0] = 10, look.eye[1] = look.target[1] = 1.2, look.eye[2] = 2;
    check(clq_camera_look_at(&look, &camera));
    check(clq_scene_find_in_frustum(scene, 0, &camera, NULL, hits, count, &got));
    expect(got > 100 && got < count, "the camera sees a part of the square");
    check(clq_view_create(crowd, &view));
    check(clq_view_set_camera(view, &camera));
    check(clq_crowd_update(crowd, 0, &view, 1));
    filter.tmpl = citizen;
    for (filter.level = 0; filter.level < 64; ++filter.level) { /* no template has more */
        check(clq_scene_find(scene, &filter, NULL, 0, &of_level));
        shown += of_level;
    }
    expect(shown > 0 && shown <= got, "those shown are among those whom the frustum meets");
    check(clq_camera_get_ray(&camera, 0, 0, &ray)); /* the middle of the window */
    check(clq_scene_find_on_ray(scene, 0, &ray, NULL, NULL, 0, &got));
    check(clq_scene_pick_triangle(scene, view, &ray, NULL, &pick));
    expect(got >= side && pick.actor.index1 == people[10].index1, "a click finds the first one of the column");
    expect(pick.zone != CLQ_NONE && pick.distance < 3, "and what of the clothes was met, and where");
}

static void ask_while_someone_moves(clq_crowd *crowd, clq_scene *scene)
{
    const clq_transform away = {{500, 0, 0}, {0, 0, 0, 1}, 1};
    clq_scene_actor known = clq_scene_actor_init();
    clq_scene_stats stats = clq_scene_stats_init();
    uint32_t got;
    check(clq_crowd_set_transforms(crowd, people, &away, 1));
    check(clq_scene_find_within(scene, 0, away.position, 1, NULL, hits, count, &got));
    expect(got == 1 && hits[0].actor.index1 == people[0].index1, "answers are right at once");
    check(clq_scene_update(scene, 1)); /* quick again */
    check(clq_scene_get_actor(scene, people[0], 1, &known));
    expect(known.position[0] == 500 && known.categories == 1u << seated, "an id finds everything known");
    check(clq_scene_get_stats(scene, &stats));
    expect(stats.marked == 0 && stats.keyed == count, "all changes were taken over");
    printf("%u people in a scene of %llu bytes\n", stats.actor_count, (unsigned long long)stats.bytes);
}

int main(void)
{
    clq_context *context;
    clq_template *citizen;
    clq_crowd *crowd;
    check(clq_context_create(NULL, &context));
    check(clq_template_builtin(context, "citizen", &citizen));
    check(clq_crowd_create(context, NULL, &crowd));
    clq_scene *scene = fill(crowd, citizen);
    ask_for_places(scene);
    ask_for_categories(scene);
    ask_for_the_picture(crowd, scene, citizen);
    ask_while_someone_moves(crowd, scene);
    check(clq_scene_destroy(scene));
    clq_template_destroy(citizen);
    check(clq_crowd_destroy(crowd));
    return clq_context_destroy(context) != CLQ_OK;
}
