#include "tests/api/test_world.h"

#include <cmath>
#include <map>
#include <string>

#include "tests/api/calls.h"

TestWorld::TestWorld(const clq_context_def *context_def)
{
    dofs[nod] = {"nod", 1, CLQ_DOF_ROTATION, 0, {1, 0, 0}, -0.5f, 0.5f, 0};
    dofs[turn] = {"turn", 1, CLQ_DOF_ROTATION, 0, {0, 1, 0}, -1, 1, 0};
    dofs[shift] = {"shift", 1, CLQ_DOF_TRANSLATION, 0, {0, 1, 0}, 0, 0.2f, 0};
    with_dofs.def.dof_count = 3, with_dofs.def.dofs = dofs;
    with_dofs.def.name = "figure", plain.def.name = "plain";
    EXPECT_EQ(clq_context_create(context_def, &context), CLQ_OK);
    EXPECT_EQ(make(with_dofs.def, &templates[0]), CLQ_OK) << clq_last_error();
    EXPECT_EQ(make(plain.def, &templates[1]), CLQ_OK) << clq_last_error();
    const clq_locomotion_def walk = Walker::locomotion(templates[0], &clip_);
    EXPECT_EQ(clq_locomotion_create(context, &walk, &locomotion), CLQ_OK) << clq_last_error();
    for (uint32_t i = 0; i < 2; ++i) EXPECT_EQ(Walker::track(locomotion, i, &tracks[i]), CLQ_OK) << clq_last_error();
}

TestWorld::~TestWorld()
{
    for (clq_crowd *crowd : crowds) clq_crowd_destroy(crowd);
    for (clq_track *track : tracks) clq_track_destroy(track);
    clq_locomotion_destroy(locomotion);
    for (clq_template *tmpl : templates) clq_template_destroy(tmpl);
    EXPECT_EQ(clq_context_destroy(context), CLQ_OK) << clq_last_error();
}

bool TestWorld::keeps_templates = false;

clq_status TestWorld::make(const clq_template_def &def, clq_template **out)
{
    static std::map<std::string, std::vector<uint8_t>> kept;
    if (!keeps_templates) return clq_template_build(context, &def, out);
    std::vector<uint8_t> &bytes = kept[def.name];
    if (!bytes.empty()) return clq_template_load(context, bytes.data(), bytes.size(), out);
    const clq_status status = clq_template_build(context, &def, out);
    const auto keep = [](void *user, const void *from, size_t size) {
        const uint8_t *first = static_cast<const uint8_t *>(from);
        std::vector<uint8_t> &to = *static_cast<std::vector<uint8_t> *>(user);
        to.insert(to.end(), first, first + size);
        return 0;
    };
    if (status == CLQ_OK) {
        EXPECT_EQ(clq_template_save(*out, keep, &bytes), CLQ_OK);
    }
    return status;
}

clq_crowd *TestWorld::new_crowd(const clq_crowd_def *def)
{
    clq_crowd *crowd = nullptr;
    EXPECT_EQ(clq_crowd_create(context, def, &crowd), CLQ_OK) << clq_last_error();
    // A saved crowd names the tracks that its actors follow.
    for (clq_track *track : tracks) EXPECT_EQ(clq_crowd_add_track(crowd, track), CLQ_OK) << clq_last_error();
    crowds.push_back(crowd);
    return crowd;
}

clq_mechanism_def TestWorld::mechanism(uint32_t kind)
{
    clq_mechanism_def out = clq_mechanism_def_init();
    out.kind = static_cast<clq_mechanism_kind>(kind);
    out.tmpl = templates[0];
    out.level_m[0] = 15, out.off_m = kind == host ? 0 : 60;
    out.gaze.neck_yaw = turn, out.gaze.neck_pitch = nod, out.gaze.wander_s = 2;
    out.expression.pose_count = out.phrase.pose_count = 2;
    out.expression.poses = out.phrase.poses = shapes_;
    out.blink.closed = shapes_[1];
    out.phrase.key_count = 2, out.phrase.keys = keys_, out.phrase.length_s = 1, out.phrase.pause_s = 1;
    out.idle.clip_count = 1, out.idle.clips = &clip_;
    out.host.run = [](void *, const clq_behaviour_call *call, clq_dof_writer *writer) {
        const bool entered = clq_floats_enter();  // it computes alike under all settings of the host
        const float value = static_cast<float>(0.1 + 0.1 * std::sin(call->time_s));
        if (entered) clq_floats_leave();
        clq_dof_write(writer, shift, value, 0.5f);
    };
    return out;
}

clq_root_path_def TestWorld::path(bool flight)
{
    clq_root_path_def out = clq_root_path_def_init();
    out.count = 3, out.positions = positions_, out.duration_s = 4;
    if (!flight) out.rotations_xyzw = rotations_, out.times_s = times_;
    return out;
}

void TestWorld::set_up(clq_crowd *crowd)
{
    clq_actor_def def = clq_actor_def_init();
    def.tmpl = templates[0];
    clq_actor first;
    ASSERT_EQ(clq_actor_create(crowd, &def, &first), CLQ_OK) << clq_last_error();
    for (uint32_t kind = gaze; kind <= host; ++kind) {
        const clq_mechanism_def wanted = mechanism(kind);
        clq_mechanism made;
        ASSERT_EQ(clq_crowd_add_mechanism(crowd, &wanted, &made), CLQ_OK) << clq_last_error();
        ASSERT_EQ(made.index1, kind + 1);
    }
    clq_gait_def gait = clq_gait_def_init();
    gait.tmpl = templates[0];
    clq_gait made_gait;
    ASSERT_EQ(clq_crowd_add_gait(crowd, &gait, &made_gait), CLQ_OK) << clq_last_error();
    clq_mask_def mask = clq_mask_def_init();
    const char *tip = "tip";
    mask.tmpl = templates[0], mask.node_count = 1, mask.nodes = &tip;
    clq_mask made_mask;
    ASSERT_EQ(clq_crowd_add_mask(crowd, &mask, &made_mask), CLQ_OK) << clq_last_error();
    for (const bool flight : {true, false}) {
        const clq_root_path_def wanted = path(flight);
        clq_root_path made;
        ASSERT_EQ(clq_crowd_add_root_path(crowd, &wanted, &made), CLQ_OK) << clq_last_error();
    }
}

std::vector<clq_actor> TestWorld::fill(clq_crowd *crowd, uint32_t count, uint64_t seed)
{
    std::vector<clq_actor> actors;
    for (uint32_t i = 0; i < count; ++i) {
        clq_actor_def def = clq_actor_def_init();
        def.tmpl = templates[i % 5 == 4];
        def.transform.position[0] = static_cast<double>(mixed(seed, 3 * i) % 1000) / 50 - 10;
        def.transform.position[2] = -static_cast<double>(mixed(seed, 3 * i + 1) % 1000) / 30 - 2;
        def.play.clip = i % 3 ? 0 : CLQ_NONE;
        def.seed = mixed(seed, i);
        clq_actor made;
        EXPECT_EQ(clq_actor_create(crowd, &def, &made), CLQ_OK) << clq_last_error();
        actors.push_back(made);
    }
    for (uint32_t step = 0; step < 8 * count; ++step) happen(crowd, actors, seed, step);
    return actors;
}

void TestWorld::add_tracks_for(clq_crowd *crowd, clq_template *tmpl)
{
    const clq_locomotion_def walk = Walker::locomotion(tmpl, &clip_);
    clq_locomotion *own = nullptr;
    ASSERT_EQ(clq_locomotion_create(context, &walk, &own), CLQ_OK) << clq_last_error();
    for (uint32_t i = 0; i < 2; ++i) {
        clq_track *track = nullptr;
        ASSERT_EQ(Walker::track(own, i, &track), CLQ_OK) << clq_last_error();
        EXPECT_EQ(clq_crowd_add_track(crowd, track), CLQ_OK) << clq_last_error();
        clq_track_destroy(track);
    }
    clq_locomotion_destroy(own);
}

clq_view *TestWorld::new_view(clq_crowd *crowd, double x)
{
    clq_view *view = nullptr;
    EXPECT_EQ(clq_view_create(crowd, &view), CLQ_OK);
    clq_camera camera;
    const double eye[3] = {x, 2, 4}, target[3] = {0, 1, -10};
    const float up[3] = {0, 1, 0};
    EXPECT_EQ(api_test::look_at(&camera, eye, target, up, 0.9f, 1.3f, 0.1f, 200), CLQ_OK);
    EXPECT_EQ(clq_view_set_camera(view, &camera), CLQ_OK);
    return view;
}

// Any of these may find no free row.
void TestWorld::blend(clq_crowd *crowd, clq_actor person, bool figure, const clq_play &play)
{
    clq_fade_def to = clq_fade_def_init();
    to.play = play;
    if (figure && play.phase_s > 0.5f) to.gait = {1}, to.share = play.phase_s;
    api_test::fade_to(crowd, person, to, play.start_s + 12, 1 + play.phase_s,
                      to.gait.index1 ? CLQ_CURVE_SMOOTH : CLQ_CURVE_INERTIAL);
    clq_actor_set_gait_share(crowd, person, play.phase_s, play.start_s + 13, 2);
    clq_layer_def layer = clq_layer_def_init();
    layer.play = play, layer.loops = 9, layer.fade_in_s = 0.5f;
    layer.kind = play.phase_s > 0.3f ? CLQ_LAYER_ADD : CLQ_LAYER_REPLACE;
    if (figure) layer.mask = {1};
    clq_actor_add_layer(crowd, person, &layer, nullptr);
    clq_actor_set_watched(crowd, person, play.phase_s > 0.2f);
}

// Members of groups, and actors of the other template, are refused.
void TestWorld::follow(clq_crowd *crowd, clq_actor person, bool figure, double at_s, uint32_t step)
{
    if (step % 3 == 0) {
        clq_actor_leave_track(crowd, person, at_s);
    } else {
        const clq_status status = clq_actor_follow_track(crowd, person, tracks[step % 2], at_s);
        EXPECT_TRUE(status == CLQ_OK ? figure : status == CLQ_ARGUMENT) << clq_last_error();
    }
    if (step % 5 == 0) clq_actor_fade_to_track(crowd, person, at_s + 1, 0.5f);
}

void TestWorld::happen(clq_crowd *crowd, std::vector<clq_actor> &actors, uint64_t seed, uint32_t step)
{
    const uint64_t bits = mixed(seed ^ 0x57a6e, step);
    clq_actor &person = actors[(bits >> 8) % actors.size()];
    const double x = static_cast<double>((bits >> 20) % 200) / 10 - 10,
                 z = -static_cast<double>((bits >> 30) % 300) / 10;
    const float share = static_cast<float>((bits >> 40) % 1000) / 1000;
    const clq_transform place = {{x, share, z}, {0, 0, 0, 1}, 0.5f + share};
    clq_actor_info info = clq_actor_info_init();
    ASSERT_EQ(clq_actor_get_info(crowd, person, &info), CLQ_OK) << clq_last_error();
    const bool figure = info.tmpl == templates[0];
    const uint32_t kind = (bits >> 50) % 6;
    const clq_mechanism_attachment use = {{kind + 1}, share, share, x};
    const clq_play play = {0, x, 0.5f + share, share};
    const clq_root_path_play motion = {{static_cast<uint32_t>((bits >> 50) % 3)}, share, 0, x};
    const float centre[3] = {0, 0.3f, 0};
    const double point[3] = {x, 1, z};
    clq_attachment attached;
    clq_group group = {1, 1};
    clq_status status = CLQ_OK;
    switch (bits % 15) {
        case 0:
            status = clq_crowd_set_transforms(crowd, &person, &place, 1);
            clq_crowd_set_speeds(crowd, &person, &share, 1);
            break;
        case 1:
            if (step % 3 == 0) status = clq_actor_play(crowd, person, &play);
            else blend(crowd, person, figure, play);
            break;
        case 2:
            status = clq_actor_randomise_colours(crowd, person, nullptr, 0);
            break;
        case 3:
            status = clq_actor_set_priority(crowd, person, share);
            break;
        case 4:
            status = api_test::attach(crowd, person, 1, centre, share, &attached);
            break;
        case 5:
            status = clq_actor_follow_ground(crowd, person, share, 0.5f);
            break;
        case 6:
            status = clq_actor_play_root_path(crowd, person, &motion);
            break;
        case 7:
            if (step % 9 == 0) status = clq_group_create(crowd, &place, &group);
            break;
        case 8:
            clq_actor_join(crowd, person, group, step % 3 ? nullptr : &place);
            break;
        case 9:
            clq_group_set_enabled(crowd, group, step % 5 != 0), clq_group_set_transform(crowd, group, &place);
            clq_group_set_speed(crowd, group, share);
            break;
        case 10:
            if (figure) status = clq_actor_attach_mechanism(crowd, person, &use);
            break;
        case 11:
            clq_actor_gaze(crowd, person, {gaze + 1}, step % 4 ? point : nullptr, x);
            clq_actor_express(crowd, person, {expression + 1}, step % 2, x);
            clq_actor_say(crowd, person, {phrase + 1}, x);
            break;
        case 12: {
            clq_actor twin;
            status = clq_actor_clone(crowd, person, &place, bits, &twin);
            ASSERT_EQ(clq_actor_destroy(crowd, person), CLQ_OK) << clq_last_error();
            person = twin;
            break;
        }
        case 13:
            follow(crowd, person, figure, x, step);
            break;
        default:
            clq_actor_detach_mechanism(crowd, person, {kind + 1});
            clq_actor_detach(crowd, {static_cast<uint32_t>((bits >> 50) % 8) + 1, 1});
    }
    EXPECT_EQ(status, CLQ_OK) << clq_last_error();
}
