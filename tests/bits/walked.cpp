// People on tracks, and the trajectories and areas that files give.
#include <claque/track.h>
#include <claque/trajectories.h>

#include "tests/bits/bits.h"

namespace bits
{

namespace
{

double steps(void *, const double point[3])  // treads of 0.15 m
{
    const OwnFloats own;
    const volatile double height = 0.15 * double(int64_t(point[2] / 0.4)) + 0.01 * point[0];  // clang computes it later
    return height;
}

// Two people who meet, at a walk, a run and a rest.
std::vector<clq_track_point> way(int person)
{
    std::vector<clq_track_point> out;
    double x = person == 0 ? -1 : 0.4, z = person == 0 ? 0 : 24;
    for (int i = 0; i < 220; ++i) {
        clq_track_point point;
        const double speed = i < 90 ? 1.2 : i < 120 ? 0.02 : i < 160 ? 0.6 : 2.6;
        point.time_s = 0.1 * i;
        x += 0.1 * speed * (i % 40 < 20 ? 0.35 : -0.3), z += (person == 0 ? 0.1 : -0.1) * speed;
        point.position[0] = x, point.position[1] = 0.05 * x, point.position[2] = z;
        point.heading_rad = i % 50 < 10 ? 0.3f + 3 * float(person) : __builtin_nanf("");
        out.push_back(point);
    }
    return out;
}

}  // namespace

void tracks(clq_context *context)
{
    clq_template *citizen = built(context, "citizen");
    clq_locomotion_def clips = clq_locomotion_def_init();
    const uint32_t stand = clq_template_find_clip(citizen, "stand");
    clips.tmpl = citizen, clips.idle_count = 1, clips.idles = &stand;
    clips.walk = clq_template_find_clip(citizen, "walk"), clips.run = clq_template_find_clip(citizen, "jog");
    clips.slow_walk = clq_template_find_clip(citizen, "walk_slow"),
    clips.turn = clq_template_find_clip(citizen, "turn");
    clq_locomotion *locomotion;
    check(clq_locomotion_create(context, &clips, &locomotion));

    const std::vector<clq_track_point> ways[2] = {way(0), way(1)};
    clq_track_def defs[2] = {clq_track_def_init(), clq_track_def_init()};
    for (int i = 0; i < 2; ++i)
        defs[i].point_count = uint32_t(ways[i].size()), defs[i].points = ways[i].data(), defs[i].seed = uint64_t(i);
    const clq_track_def *const both[] = {&defs[0], &defs[1]};
    clq_found_passing found[64];
    size_t found_count = 0;
    check(clq_find_passings(context, both, 2, found, 64, &found_count));
    std::vector<clq_track_passing> passings[2];
    for (size_t i = 0; i < found_count; ++i) passings[found[i].track].push_back(found[i].passing);

    clq_crowd *crowd;
    clq_view *view;
    check(clq_crowd_create(context, nullptr, &crowd));
    Hash made;
    for (int i = 0; i < 2; ++i) {
        defs[i].passings = passings[i].data(), defs[i].passing_count = uint32_t(passings[i].size());
        if (i == 1) defs[i].ground = steps;
        clq_track *track;
        check(clq_track_create(locomotion, &defs[i], &track));
        check(clq_track_save(track, Hash::write, &made));
        clq_actor actor;
        clq_actor_def def = clq_actor_def_init();
        def.tmpl = citizen;
        check(clq_actor_create(crowd, &def, &actor));
        check(clq_actor_follow_track(crowd, actor, track, 0));
        for (int k = 0; k < 400; ++k) {
            clq_track_state state;
            check(clq_track_evaluate(track, 0.06 * k, &state));
            made.add(state.position, sizeof state.position), made.add(&state.heading_rad, sizeof state.heading_rad);
            made.add(&state.phase, sizeof state.phase), made.add(&state.gait, sizeof state.gait);
        }
        clq_track_destroy(track);
    }
    print("tracks", made);

    const double eye[3] = {-9, 4, 12}, target[3] = {0, 1, 12};
    const clq_camera camera = camera_at(eye, target);
    check(clq_view_create(crowd, &view));
    check(clq_view_set_camera(view, &camera));
    Seen seen;
    for (int frame = 0; frame < 120; ++frame) {
        check(clq_crowd_update(crowd, 0.18 * frame, &view, 1));
        seen.add(view, true);
    }
    print("poses.tracks", seen.palettes);
    print("list.tracks", seen.list);
    check(clq_crowd_destroy(crowd));
    clq_locomotion_destroy(locomotion), clq_template_destroy(citizen);
}

void files(clq_context *context)
{
    static const char table[] =
        "# framerate: 10\n# id frame x y z\n1 0 0.5 1.25 1.7\n1 1 0.6 1.3 1.7\n1 2 0.75 1.31 1.7\n"
        "1 3 0.8 1.2 1.7\n2 1 4 3 1.7\n2 2 3.9 3.1 1.7\n2 3 3.75 3.3 1.7\n2 4 3.5 3.3 1.7\n";
    clq_trajectories *trajectories;
    clq_trajectories_info info = clq_trajectories_info_init();
    check(clq_trajectories_load_memory(context, table, sizeof table - 1, "table.txt", nullptr, &trajectories));
    check(clq_trajectories_get_info(trajectories, &info));
    Hash read;
    const clq_trajectory_sample *samples = clq_trajectories_get_samples(trajectories);
    for (uint64_t i = 0; i < info.sample_count; ++i)
        read.add(&samples[i], sizeof(double) * 4), read.add(&samples[i].heading_rad, sizeof(float));
    print("trajectories", read);
    clq_trajectories_destroy(trajectories);

    static const char wkt[] =
        "POLYGON ((0 0, 9 0.5, 8.75 7, 4 5.3, 0.3 8), (2 2, 2.1 3, 3 3.3, 3 1.9), (5 3, 6.1 3.2, 5.7 2))";
    clq_area *area;
    clq_area_info filled = clq_area_info_init();
    check(clq_area_load_memory(context, wkt, sizeof wkt - 1, "floor.wkt", &area));
    check(clq_area_get_info(area, &filled));
    Hash triangles;
    triangles.add(filled.points_m, 3 * filled.point_count * sizeof *filled.points_m);
    triangles.add(filled.triangles, 3 * filled.triangle_count * sizeof *filled.triangles);
    print("area", triangles);
    clq_area_destroy(area);
}

}  // namespace bits
