/* An actor walks where a list of points says: to a bench, along a corner, with a rest in between. Its feet stand while
 * they carry weight. It leaves its track, and a saved track is loaded again. */
#include <claque/assets.h>

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "samples/examples/check.h"

static unsigned char saved[1 << 16];
static size_t saved_bytes;

static int keep(void *user, const void *bytes, size_t size_bytes)
{
    (void)user;
    if (size_bytes > sizeof saved - saved_bytes) return 1;
    memcpy(saved + saved_bytes, bytes, size_bytes);
    saved_bytes += size_bytes;
    return 0;
}

/* Eight seconds ahead along +z, four of rest, eight along +x, at 1.1 m/s and ten points a second. */
static void fill(clq_track_point points[200])
{
    for (int i = 0; i < 200; ++i) {
        const double t = 0.1 * i, ahead = fmin(t, 8), across = fmax(t - 12, 0);
        clq_track_point *point = &points[i];
        memset(point, 0, sizeof *point);
        point->time_s = t;
        point->position[0] = 1.1 * across, point->position[2] = 1.1 * ahead;
        point->heading_rad = (float)NAN; /* along the path */
    }
}

int main(void)
{
    clq_context *context;
    clq_template *citizen;
    clq_locomotion *locomotion;
    clq_track *track, *loaded;
    clq_crowd *crowd;
    clq_actor actor;
    check(clq_context_create(NULL, &context));
    check(clq_template_builtin(context, "citizen", &citizen));

    clq_locomotion_def walk = clq_locomotion_def_init();
    const uint32_t stand = clq_template_find_clip(citizen, "stand");
    walk.tmpl = citizen;
    walk.walk = clq_template_find_clip(citizen, "walk"), walk.run = clq_template_find_clip(citizen, "jog");
    walk.slow_walk = clq_template_find_clip(citizen, "walk_slow"), walk.turn = clq_template_find_clip(citizen, "turn");
    walk.idle_count = 1, walk.idles = &stand;
    check(clq_locomotion_create(context, &walk, &locomotion));
    clq_locomotion_info measured = clq_locomotion_info_init();
    check(clq_locomotion_get_info(locomotion, &measured));
    expect(measured.walk_speed > 1 && measured.run_speed > measured.walk_speed, "a walk and a run were measured");

    clq_track_point points[200];
    fill(points);
    clq_track_def def = clq_track_def_init();
    def.point_count = 200, def.points = points;
    check(clq_track_create(locomotion, &def, &track));
    clq_track_info info = clq_track_info_init();
    check(clq_track_get_info(track, &info));
    expect(info.standing_s > 1.5 && info.standing_s < 4, "it rests, and turns before it goes on");
    expect(info.max_shift_m < 0.3, "the path shown is near that given");

    clq_track_state state;
    check(clq_track_evaluate(track, 4, &state));
    expect(state.present && !state.stands && fabs(state.gait - 1) < 0.1, "after four seconds it walks");
    expect(fabs(state.position[2] - 4.4) < 0.02 && fabs(state.heading_rad) < 0.02, "and is where the points say");
    check(clq_track_evaluate(track, 10, &state));
    expect(state.stands && state.gait == 0, "after ten it stands");

    clq_track_plant plants[32];
    size_t plant_count = 0;
    check(clq_track_get_plants(track, 0, 2, 6, plants, 32, &plant_count));
    expect(plant_count >= 3 && plants[1].position[2] > plants[0].position[2], "its left foot goes ahead step by step");

    check(clq_crowd_create(context, NULL, &crowd));
    clq_actor_def actor_def = clq_actor_def_init();
    actor_def.tmpl = citizen;
    check(clq_actor_create(crowd, &actor_def, &actor));
    check(clq_actor_follow_track(crowd, actor, track, 100)); /* it appears at 100 s of the crowd's clock */
    double before[16], after[16];
    uint32_t rests = 0;
    const uint32_t foot = measured.legs[0].toes;
    for (int i = 0; i < 100; ++i) {
        check(clq_actor_get_node(crowd, actor, foot, 103 + 0.02 * i, before));
        check(clq_actor_get_node(crowd, actor, foot, 103.02 + 0.02 * i, after));
        rests += hypot(after[12] - before[12], after[14] - before[14]) < 0.004;
    }
    expect(rests > 40 && rests < 80, "about half of the time its left foot rests, though the body goes on");

    check(clq_actor_leave_track(crowd, actor, 104)); /* it stays where it was after four seconds */
    clq_actor_info found = clq_actor_info_init();
    check(clq_actor_get_info(crowd, actor, &found));
    expect(fabs(found.transform.position[2] - 4.4) < 0.02, "it left its track after 4.4 m");
    check(clq_actor_follow_track(crowd, actor, track, 100));
    clq_play wave = clq_play_init();
    wave.clip = clq_template_find_clip(citizen, "stand_wave"), wave.start_s = 109;
    check(clq_actor_play(crowd, actor, &wave));                /* in place of the gait, while it rests */
    check(clq_actor_fade_to_track(crowd, actor, 111.0, 0.5f)); /* and on */

    check(clq_track_save(track, keep, NULL));
    check(clq_track_load(locomotion, saved, saved_bytes, &loaded));
    clq_track_info again = clq_track_info_init();
    check(clq_track_get_info(loaded, &again));
    expect(again.hash == info.hash, "a loaded track is the saved one");
    check(clq_crowd_add_track(crowd, loaded)); /* so that a saved crowd finds it */

    clq_track_destroy(loaded);
    clq_track_destroy(track);
    clq_locomotion_destroy(locomotion);
    clq_template_destroy(citizen);
    check(clq_crowd_destroy(crowd));
    check(clq_context_destroy(context));
    return puts("an actor walked, rested, turned a corner and left its track") < 0;
}
