/* A room with a wall and a door: the shortest way through it, a walker that takes it, and a crowd that shows the pieces
 * of its track while they are decided. */
#include <claque/assets.h>
#include <claque/navigation.h>
#include <claque/stage.h>

#include <math.h>

#include "samples/examples/check.h"

/* A floor of 10 m by 10 m round the origin, and a wall across it that ends 1 m before its right side. */
static const double floor_corners[12] = {-5, 0, -5, -5, 0, 5, 5, 0, 5, 5, 0, -5};
static const uint32_t floor_triangles[6] = {0, 1, 2, 0, 2, 3};
static const double wall_corners[8] = {-5, -0.2, 3.8, -0.2, 3.8, 0.2, -5, 0.2};
static const double door_corners[8] = {3.8, -0.2, 5, -0.2, 5, 0.2, 3.8, 0.2};

static clq_navigation *room(void)
{
    const clq_prism wall = {4, wall_corners, -1, 3}, door = {4, door_corners, -1, 3};
    clq_navigation_def def = clq_navigation_def_init();
    clq_navigation *made;
    def.vertex_count = 4, def.vertices = floor_corners;
    def.triangle_count = 2, def.triangles = floor_triangles;
    def.hole_count = 1, def.holes = &wall;
    def.door_count = 1, def.doors = &door;
    check(clq_navigation_create(&def, &made));
    return made;
}

static void find_ways(clq_navigation *navigation, const double from[3], const double to[3])
{
    clq_navigation_info info = clq_navigation_info_init();
    clq_way way = clq_way_init();
    double near_by[3], corners[3 * 16];
    bool found = false, open = false;
    check(clq_navigation_get_info(navigation, &info));
    expect(info.door_count == 1 && info.area_m2 > 70 && info.area_m2 < 100, "most of the floor can be walked on");
    check(clq_navigation_find_nearest(navigation, to, 1, near_by, &found));
    expect(found && fabs(near_by[2] - to[2]) < 0.1, "the goal is on the ground");
    check(clq_navigation_find_way(navigation, from, to, 16, corners, &way));
    expect(way.complete && way.point_count > 2 && way.length > 8, "the way leads round the wall");
    check(clq_navigation_set_door(navigation, 0, false));
    check(clq_navigation_get_door(navigation, 0, &open));
    check(clq_navigation_find_way(navigation, from, to, 0, NULL, &way));
    expect(!open && !way.complete, "no way leads through a closed door");
    check(clq_navigation_set_door(navigation, 0, true));
}

/* Walks for `seconds`; the actor follows each piece of its track as it is published. */
static void walk(clq_walkers *walkers, clq_crowd *crowd, clq_actor actor, double seconds)
{
    for (int tick = 0; tick < 20 * seconds; ++tick) {
        const clq_walker_piece *pieces;
        uint32_t count = 0;
        check(clq_walkers_step(walkers));
        check(clq_walkers_get_pieces(walkers, &pieces, &count));
        for (uint32_t i = 0; i < count; ++i) {
            clq_track_hold(pieces[i].track); /* as a host that keeps pieces would */
            check(clq_actor_follow_track(crowd, actor, pieces[i].track, 0));
            clq_track_destroy(pieces[i].track);
        }
    }
    check(clq_crowd_release_tracks(crowd, NULL));
}

int main(void)
{
    const double from[3] = {-3, 0, -3}, to[3] = {-3, 0, 3};
    clq_context *context;
    clq_template *citizen;
    clq_locomotion *locomotion;
    clq_crowd *crowd;
    clq_actor actor;
    clq_walkers *walkers;
    clq_walker walker;
    clq_stage *stage;
    clq_navigation *navigation = room();
    find_ways(navigation, from, to);

    check(clq_context_create(NULL, &context));
    check(clq_template_builtin(context, "citizen", &citizen));
    clq_locomotion_def clips = clq_locomotion_def_init();
    clips.tmpl = citizen, clips.walk = clq_template_find_clip(citizen, "walk");
    check(clq_locomotion_create(context, &clips, &locomotion));
    check(clq_crowd_create(context, NULL, &crowd));
    clq_actor_def person = clq_actor_def_init();
    person.tmpl = citizen;
    check(clq_actor_create(crowd, &person, &actor));

    check(clq_walkers_create(navigation, NULL, &walkers));
    clq_walker_def def = clq_walker_def_init();
    def.locomotion = locomotion;
    for (int k = 0; k < 3; ++k) def.position[k] = from[k];
    check(clq_walkers_add(walkers, &def, &walker));
    check(clq_walker_go(walkers, walker, to, 0.3f, 0));
    walk(walkers, crowd, actor, 20);
    clq_walker_info arrived = clq_walker_info_init();
    clq_walkers_info all = clq_walkers_info_init();
    check(clq_walkers_get_walker(walkers, walker, &arrived));
    check(clq_walkers_get_info(walkers, &all));
    expect(arrived.state == CLQ_WALKER_ARRIVED && arrived.position[2] > 2, "it is behind the wall");
    expect(all.count == 1 && all.pieces > 10, "its track came in pieces");
    check(clq_walker_stop(walkers, walker));
    check(clq_walkers_remove(walkers, walker));
    clq_walkers_destroy(walkers);

    /* The agents of a stage walk on the same ground. */
    check(clq_stage_create(context, NULL, &stage));
    check(clq_stage_set_navigation(stage, navigation, NULL, (const clq_locomotion *const *)&locomotion, 1));
    clq_stage_destroy(stage);
    clq_navigation_destroy(navigation);
    clq_crowd_destroy(crowd), clq_locomotion_destroy(locomotion), clq_template_destroy(citizen);
    clq_context_destroy(context);
    return 0;
}
