// Crowds that stand, play, fade and fly, as views see them.
#include <claque/behave.h>
#include <claque/colours.h>
#include <claque/play.h>
#include <claque/simd.h>

#include "tests/bits/bits.h"

namespace bits
{

namespace
{

// A crowd with one view of it.
struct Show {
    clq_crowd *crowd;
    clq_view *view;

    Show(clq_context *context, const clq_crowd_def &def, const clq_camera &camera)
    {
        check(clq_crowd_create(context, &def, &crowd));
        check(clq_view_create(crowd, &view));
        check(clq_view_set_camera(view, &camera));
    }
    ~Show() { clq_crowd_destroy(crowd); }
    clq_actor add(clq_template *tmpl, uint32_t clip, uint32_t number)
    {
        clq_actor actor;
        clq_actor_def def = clq_actor_def_init();
        def.tmpl = tmpl, def.seed = number;
        def.transform.position[0] = 1.25 * (number % 12) - 7, def.transform.position[2] = -0.75 * number;
        def.transform.orientation_xyzw[1] = 0.6f, def.transform.orientation_xyzw[3] = 0.8f;
        def.play.clip = clip, def.play.speed = 0.75f + 0.125f * float(number % 5);
        def.play.phase_s = 0.3f * float(number % 7);
        check(clq_actor_create(crowd, &def, &actor));
        check(clq_actor_randomise_colours(crowd, actor, nullptr, 0));
        return actor;
    }
    void see(Seen &seen, double time_s, bool with_palettes = true)
    {
        check(clq_crowd_update(crowd, time_s, &view, 1));
        seen.add(view, with_palettes);
    }
};

const double eye[3] = {1000001.5, 2.5, 6}, target[3] = {1000000, 1, -14};

// Every clip of every character, with fades and layers.
void fill(Show &show, const std::vector<clq_template *> &all)
{
    uint32_t number = 0;
    for (clq_template *tmpl : all) {
        clq_template_info info = clq_template_info_init();
        check(clq_template_get_info(tmpl, &info));
        for (uint32_t clip = 0; clip < info.clip_count; ++clip, ++number) {
            const clq_actor actor = show.add(tmpl, clip, number);
            if (number % 3 == 0) {
                clq_fade_def fade = clq_fade_def_init();
                fade.play.clip = (clip + 1) % info.clip_count, fade.at_s = 0.4, fade.length_s = 0.9f;
                fade.curve = number % 2 == 0 ? CLQ_CURVE_SMOOTH : CLQ_CURVE_INERTIAL;
                check(clq_actor_fade_to(show.crowd, actor, &fade));
            } else if (number % 3 == 1) {
                clq_layer_def layer = clq_layer_def_init();
                layer.kind = number % 2 == 0 ? CLQ_LAYER_REPLACE : CLQ_LAYER_ADD;
                layer.play.clip = (clip + 2) % info.clip_count, layer.weight = 0.7f;
                check(clq_actor_add_layer(show.crowd, actor, &layer, nullptr));
            }
        }
    }
}

void print_seen(const std::string &name, const Seen &seen)
{
    print("poses." + name, seen.palettes);
    print("vertices." + name, seen.vertices);
    print("list." + name, seen.list);
}

double hill(void *, const double point[3])
{
    const OwnFloats own;
    return 0.25 + (point[0] - 1000003) * 0.0625 - point[2] * 0.03125;
}

}  // namespace

void crowds(clq_context *context)
{
    std::vector<clq_template *> all;
    for (const char *name : {"citizen", "patrician", "decurion", "plebeian", "herald", "owl"})
        all.push_back(built(context, name));
    const double near_eye[3] = {1.5, 2.5, 6}, near_target[3] = {0, 1, -14};
    const clq_camera camera = camera_at(near_eye, near_target);
    for (const auto &[name, simd] : {std::pair<const char *, clq_simd>{"scalar", CLQ_SIMD_SCALAR},
                                     {"128", CLQ_SIMD_128},
                                     {"widest", CLQ_SIMD_WIDEST}}) {
        check(clq_simd_set(simd));
        Show show(context, clq_crowd_def_init(), camera);
        fill(show, all);
        Seen seen;
        for (int frame = 0; frame < 12; ++frame) show.see(seen, 0.125 * frame);
        print_seen(name, seen);
    }
    for (const auto &[name, mode] :
         {std::pair<const char *, clq_key_pose_mode>{"intermittent", CLQ_KEY_POSE_INTERMITTENT},
          {"interpolated", CLQ_KEY_POSE_INTERPOLATED}}) {
        clq_crowd_def def = clq_crowd_def_init();
        def.key_poses.band_count = 1, def.key_poses.bands[0].mode = mode;
        def.vertex_format = mode == CLQ_KEY_POSE_INTERPOLATED ? CLQ_VERTEX_PACKED : CLQ_VERTEX_FLOAT;
        Show show(context, def, camera);
        fill(show, all);
        Seen seen;
        for (int frame = 0; frame < 12; ++frame) show.see(seen, 0.125 * frame, false);
        print(std::string("key_poses.") + name, seen.vertices);
        print(std::string("key_poses.list.") + name, seen.list);
    }
    for (clq_template *tmpl : all) clq_template_destroy(tmpl);
}

void mechanisms(clq_context *context)
{
    clq_template *herald = built(context, "herald");
    Show show(context, clq_crowd_def_init(), camera_at(eye, target));
    clq_root_path_def path = clq_root_path_def_init();
    const float places[] = {0, 1, 0, 3, 2, 1, 4, 1.5f, -3, 0, 0.5f, -2};
    clq_root_path lap;
    path.count = 4, path.positions = places, path.duration_s = 7;
    check(clq_crowd_add_root_path(show.crowd, &path, &lap));
    check(clq_crowd_set_ground(show.crowd, hill, nullptr));
    clq_mechanism_attachment gaze = clq_mechanism_attachment_init();
    for (uint32_t i = 0; i < 12; ++i) {
        const clq_actor actor = show.add(herald, i % 3, i);
        if (i == 0) {
            clq_mechanism_def def = clq_mechanism_def_init();
            def.tmpl = herald, def.kind = CLQ_MECHANISM_GAZE, def.gaze.wander_s = 1;
            def.gaze.neck_yaw = clq_template_find_dof(herald, "neck_yaw");
            def.gaze.neck_pitch = clq_template_find_dof(herald, "neck_pitch");
            check(clq_crowd_add_mechanism(show.crowd, &def, &gaze.mechanism));
        }
        check(clq_actor_attach_mechanism(show.crowd, actor, &gaze));
        clq_root_path_play flight = clq_root_path_play_init();
        flight.path = lap, flight.phase_s = 0.5f * float(i);
        clq_transform at = clq_transform_init();
        at.position[0] = 1000000 + 2.0 * i - 12, at.position[2] = -10 - 0.5 * i;
        check(clq_crowd_set_transforms(show.crowd, &actor, &at, 1));
        if (i % 2 == 0) check(clq_actor_play_root_path(show.crowd, actor, &flight));
        else check(clq_actor_follow_ground(show.crowd, actor, 5, 5));
        const double point[3] = {1000004, 1.5, 3.0 - i};
        if (i % 4 != 0) check(clq_actor_gaze(show.crowd, actor, gaze.mechanism, point, 0.25));
    }
    Seen seen;
    for (int frame = 0; frame < 30; ++frame) show.see(seen, 0.21 * frame);
    print_seen("mechanisms", seen);
    clq_template_destroy(herald);
}

}  // namespace bits
