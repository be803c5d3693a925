// Numbers outside their limits in the definitions of crowds, templates and plays are refused by the member's name.
#include <claque/claque.h>

#include <cmath>
#include <functional>
#include <string>

#include "tests/api/arm.h"
#include "tests/api/calls.h"

namespace
{

class DefinitionLimits : public testing::Test
{
protected:
    void told(clq_status status, const std::string &sentence, clq_status wanted = CLQ_ARGUMENT) const
    {
        EXPECT_EQ(status, wanted) << sentence;
        EXPECT_NE(std::string(clq_last_error()).find(sentence), std::string::npos)
            << clq_last_error() << "\nand not: " << sentence;
    }
    void crowd(const std::string &sentence, const std::function<void(clq_crowd_def &)> &breaks)
    {
        clq_crowd_def def = clq_crowd_def_init();
        breaks(def);
        clq_crowd *made = nullptr;
        told(clq_crowd_create(arm_.context, &def, &made), sentence);
        EXPECT_EQ(made, nullptr);
    }
    void character(const std::string &sentence, const std::function<void(SmallTemplate &)> &breaks)
    {
        SmallTemplate small;
        breaks(small);
        clq_template *made = nullptr;
        told(clq_template_build(arm_.context, &small.def, &made), sentence);
        EXPECT_EQ(made, nullptr);
    }

    Arm arm_;
};

TEST_F(DefinitionLimits, OfACrowdAreNamed)
{
    using Def = clq_crowd_def;
    const auto each = [&](const char *member, float Def::*number, std::initializer_list<float> values) {
        for (const float value : values) crowd(std::string(member) + " is ", [&](Def &def) { def.*number = value; });
    };
    each("period_near_s", &Def::period_near_s, {-0.01f, 1.01f, NAN});
    each("period_far_s", &Def::period_far_s, {-1, NAN, INFINITY});
    each("distance_near_m", &Def::distance_near_m, {-1, NAN, 1e9f});
    each("metres_per_unit", &Def::metres_per_unit, {0, -1, NAN, INFINITY});
    each("lod_scale", &Def::lod_scale, {-1, NAN, INFINITY});
    each("lod_hysteresis", &Def::lod_hysteresis, {-0.1f, 1, NAN});
    each("motion_tolerance_px", &Def::motion_tolerance_px, {-1, NAN, INFINITY});
    each("update_budget_ms", &Def::update_budget_ms, {-1, NAN, INFINITY});
    crowd("0 <= near < far is wanted", [](Def &def) { def.distance_far_m = INFINITY; });
    crowd("0 <= near < far is wanted", [](Def &def) { def.distance_far_m = NAN; });
    crowd("cull is neither CLQ_CULL_ACTOR nor", [](Def &def) { def.cull = static_cast<clq_cull_mode>(2); });
    crowd("rigid_mode is neither", [](Def &def) { def.rigid_mode = static_cast<clq_rigid_mode>(2); });
    crowd("clock is neither", [](Def &def) { def.clock = static_cast<clq_clock>(2); });
    crowd("CLQ_CULL_TRADITIONAL keep none",
          [](Def &def) { def.clock = CLQ_CLOCK_LIVE, def.update_budget = 3, def.cull = CLQ_CULL_TRADITIONAL; });
}

TEST_F(DefinitionLimits, OfATemplatesArraysAreNamed)
{
    using S = SmallTemplate;
    character("nodes is NULL with a count of 2", [](S &s) { s.def.nodes = nullptr; });
    character("joints is NULL with a count of 2", [](S &s) { s.def.joints = nullptr; });
    character("images is NULL with a count of 1", [](S &s) { s.def.images = nullptr; });
    character("zones is NULL with a count of 2", [](S &s) { s.def.zones = nullptr; });
    character("materials is NULL with a count of 1", [](S &s) { s.def.materials = nullptr; });
    character("parts is NULL with a count of 1", [](S &s) { s.def.parts = nullptr; });
    character("clips is NULL with a count of 1", [](S &s) { s.def.clips = nullptr; });
    character("markers is NULL with a count of 3", [](S &s) { s.def.marker_count = 3; });
    character("root_motions is NULL with a count of 4", [](S &s) { s.def.root_motion_count = 4; });
    character("texture_sets is NULL with a count of 5", [](S &s) { s.def.texture_set_count = 5; });
    character("degrees of freedom is NULL with a count of 6", [](S &s) { s.def.dof_count = 6; });
    character("images of a texture set is NULL with a count of 1", [](S &s) {
        static const clq_texture_set_def set = {};
        s.def.texture_sets = &set, s.def.texture_set_count = 1;
    });
    character("image 0 'strip' has no array", [](S &s) { s.images[0].rgba = nullptr; });
    character("image 0 'strip' has an unknown meaning of alpha",
              [](S &s) { s.images[0].alpha = static_cast<clq_alpha_meaning>(2); });
    const std::string look = "material 0 'strip' has an unknown wrap or alpha mode";
    character(look, [](S &s) { s.materials[0].wrap_s = static_cast<clq_wrap>(3); });
    character(look, [](S &s) { s.materials[0].wrap_t = static_cast<clq_wrap>(3); });
    character(look, [](S &s) { s.materials[0].alpha_mode = static_cast<clq_alpha_mode>(2); });
    for (const float number : {NAN, INFINITY}) {
        character("motion_error", [number](S &s) { s.def.motion_error = number; });
        character("motion_error", [number](S &s) { s.def.motion_error_rad = number; });
    }
    character("motion_error", [](S &s) { s.def.motion_error_rad = -0.1f; });
}

TEST_F(DefinitionLimits, OfAPartAreNamed)
{
    using S = SmallTemplate;
    character("part 0 'strip' has no positions", [](S &s) { s.parts[0].positions = nullptr; });
    character("part 0 'strip' has no positions", [](S &s) { s.parts[0].vertex_count = 0; });
    character("part 0 'strip' has 0 indices and 10 vertices: three a triangle",
              [](S &s) { s.parts[0].index_count = 0; });
    character("indices is NULL with a count of 24", [](S &s) { s.parts[0].indices = nullptr; });
    character("skinned part 0 'strip' lacks joints or weights", [](S &s) { s.parts[0].joints = nullptr; });
    character("skinned part 0 'strip' lacks joints or weights", [](S &s) { s.parts[0].weights = nullptr; });
    character("rigid part 0 'strip' hangs on node 2, which does not exist: there are 2",
              [](S &s) { s.parts[0].influence_count = 0, s.parts[0].node = 2; });
    character("morphs is NULL with a count of 2", [](S &s) { s.parts[0].morph_count = 2; });
    character("morphed part 0 'strip' names node 7, which does not exist: there are 2", [](S &s) {
        static const clq_morph_def morph = {};
        s.parts[0].morphs = &morph, s.parts[0].morph_count = 1, s.parts[0].node = 7;
    });
}

TEST_F(DefinitionLimits, OfAClipAreNamed)
{
    using S = SmallTemplate;
    character("channel 0 of clip 0 has no keys", [](S &s) { s.channels[0].key_count = 0; });
    character("channel 0 of clip 0 has no keys", [](S &s) { s.channels[0].times_s = nullptr; });
    character("channel 0 of clip 0 has no keys", [](S &s) { s.channels[0].values = nullptr; });
    const std::string unknown = "channel 0 of clip 0 has an unknown target or interpolation";
    character(unknown, [](S &s) { s.channels[0].target = static_cast<clq_channel_target>(4); });
    character(unknown, [](S &s) { s.channels[0].interpolation = static_cast<clq_interpolation>(3); });
    character("channel 0 of clip 0 animates morph weights of node 1, which has no morphed part",
              [](S &s) { s.channels[0].target = CLQ_CHANNEL_MORPH_WEIGHTS; });
    for (const float time_s : {NAN, INFINITY})
        character("marker 0 'down' has a time that is not finite", [time_s](S &s) {
            static clq_marker_def marker;
            marker = {0, time_s, "down"};
            s.def.markers = &marker, s.def.marker_count = 1;
        });
}

TEST_F(DefinitionLimits, OfGaitsAndMasksAreNamed)
{
    const auto gait = [&](const std::string &sentence, const std::function<void(clq_gait_def &)> &breaks) {
        clq_gait_def def = clq_gait_def_init();
        def.tmpl = arm_.tmpl, def.clip_a = Arm::slow, def.clip_b = Arm::fast;
        breaks(def);
        clq_gait made = {};
        told(clq_crowd_add_gait(arm_.crowd, &def, &made), sentence);
        EXPECT_EQ(made.index1, 0u);
    };
    gait("tmpl is NULL", [](clq_gait_def &def) { def.tmpl = nullptr; });
    gait("clip_a is clip 4, which does not exist: there are 4", [](clq_gait_def &def) { def.clip_a = 4; });
    gait("clip_b is clip 9, which does not exist: there are 4", [](clq_gait_def &def) { def.clip_b = 9; });
    gait("sync_a_s is NULL with a count of 2", [](clq_gait_def &def) { def.sync_count = 2; });
    const float times[2] = {0, 0.5f};
    gait("sync_b_s is NULL with a count of 2", [&](clq_gait_def &def) { def.sync_a_s = times, def.sync_count = 2; });
    gait("have 0 and 0 markers 'up': equally many are wanted", [](clq_gait_def &def) { def.sync_marker = "up"; });
    gait("have 2 and 1 markers 'down': equally many are wanted", [](clq_gait_def &def) { def.sync_marker = "down"; });
    const char *const names[2] = {"hand", nullptr}, *const other = "knee";
    const auto mask = [&](const std::string &sentence, const std::function<void(clq_mask_def &)> &breaks) {
        clq_mask_def def = clq_mask_def_init();
        def.tmpl = arm_.tmpl, def.nodes = names, def.node_count = 1;
        breaks(def);
        clq_mask made = {};
        told(clq_crowd_add_mask(arm_.crowd, &def, &made), sentence);
        EXPECT_EQ(made.index1, 0u);
    };
    mask("tmpl is NULL", [](clq_mask_def &def) { def.tmpl = nullptr; });
    mask("nodes is NULL with a count of 1", [](clq_mask_def &def) { def.nodes = nullptr; });
    mask("a mask has no nodes", [](clq_mask_def &def) { def.node_count = 0; });
    mask("name 1 of a mask is NULL", [](clq_mask_def &def) { def.node_count = 2; });
    mask("has no node 'knee'", [&](clq_mask_def &def) { def.nodes = &other; });
    mask("a feather of 1001 nodes: at most 1000", [](clq_mask_def &def) { def.feather = 1001; });
}

TEST_F(DefinitionLimits, OfLayersAndCurvesAreNamed)
{
    const auto layer = [&](const std::string &sentence, const std::function<void(clq_layer_def &)> &breaks) {
        clq_layer_def def = clq_layer_def_init();
        def.play.clip = Arm::wave;
        breaks(def);
        clq_layer made = {};
        told(clq_actor_add_layer(arm_.crowd, arm_.actor, &def, &made), sentence);
        EXPECT_EQ(made.index1, 0u);
    };
    layer("kind is neither CLQ_LAYER_REPLACE nor CLQ_LAYER_ADD",
          [](clq_layer_def &def) { def.kind = static_cast<clq_layer_kind>(2); });
    layer("curve is none of", [](clq_layer_def &def) { def.curve = static_cast<clq_curve>(3); });
    for (const float loops : {-1.0f, NAN, INFINITY})
        layer("loops: 0 or more is wanted", [loops](clq_layer_def &def) { def.loops = loops; });
    layer("a layer of 2 loops of a clip that stands still",
          [](clq_layer_def &def) { def.loops = 2, def.play.speed = 0; });
    layer("a layer of 2 loops of a clip that stands still",
          [](clq_layer_def &def) { def.loops = 2, def.play.clip = CLQ_NONE; });
    told(api_test::fade_to(arm_.crowd, arm_.actor, arm_.motion(Arm::fast, 0), 1, 1, static_cast<clq_curve>(3)),
         "curve is none of");
}

TEST_F(DefinitionLimits, OfPlaysAtRandomAreNamed)
{
    const uint32_t clips[2] = {Arm::slow, Arm::fast};
    float weights[2] = {1, 1};
    const auto play = [&](const std::string &sentence, const std::function<void(clq_random_play_def &)> &breaks) {
        clq_random_play_def def = clq_random_play_def_init();
        def.clips = clips, def.clip_count = 2;
        breaks(def);
        clq_play made = {77, 0, 0, 0};
        told(api_test::sample_play(arm_.crowd, arm_.actor, def, 0, 0, &made), sentence);
        EXPECT_EQ(made.clip, 77u);
    };
    const auto weighted = [&](clq_random_play_def &def) { def.weights = weights; };
    for (const float weight : {-1.0f, NAN, INFINITY}) {
        weights[1] = weight;
        play("the weight of clip 1 is ", weighted);
    }
    weights[0] = weights[1] = 0;
    play("the weights of all 2 clips are 0", weighted);
    play("clips is NULL, or clip_count is 0", [](clq_random_play_def &def) { def.clip_count = 0; });
    play("clips is NULL, or clip_count is 0", [](clq_random_play_def &def) { def.clips = nullptr; });
    for (const float spread : {-1e-6f, 1.0f, NAN})
        play("0 to less than 1 is wanted", [spread](clq_random_play_def &def) { def.speed_spread = spread; });
    for (const float spread : {-1e-6f, std::nextafter(1.0f, 2.0f), NAN})
        play("0 to 1 is wanted", [spread](clq_random_play_def &def) { def.phase_spread = spread; });
    for (const double bad : {NAN, INFINITY}) {
        double motion[3] = {7, 7, 7};
        told(clq_template_get_root_motion(arm_.tmpl, 0, bad, 1, motion), "finite times are wanted");
        told(clq_template_get_root_motion(arm_.tmpl, 0, 0, bad, motion), "finite times are wanted");
        EXPECT_EQ(motion[0], 7);
        size_t count = 77;
        told(api_test::get_events(arm_.crowd, bad, 1, nullptr, 0, &count), "finite times are wanted");
        told(api_test::get_events(arm_.crowd, 0, bad, nullptr, 0, &count), "finite times are wanted");
        EXPECT_EQ(count, 77u);
    }
    double motion[3];
    told(clq_template_get_root_motion(arm_.tmpl, 4, 0, 1, motion), "clip 4 does not exist: 'strip' has 4");
}

TEST_F(DefinitionLimits, OfCamerasAreNamed)
{
    const auto looks = [&](const std::string &sentence, const std::function<void(clq_look_at_def &)> &breaks) {
        clq_look_at_def def = clq_look_at_def_init();
        def.target[2] = -1;
        breaks(def);
        clq_camera camera = {};
        told(clq_camera_look_at(&def, &camera), sentence);
        EXPECT_EQ(camera.projection[11], 0);
    };
    using Def = clq_look_at_def;
    const std::string perspective = "0 to pi, above 0 and 0 < z_near < z_far are wanted";
    for (const float number : {0.0f, 3.15f, NAN}) looks(perspective, [number](Def &def) { def.fov_y_rad = number; });
    for (const float number : {0.0f, NAN, INFINITY}) looks(perspective, [number](Def &def) { def.aspect = number; });
    for (const float number : {0.0f, 1000.0f, NAN}) looks(perspective, [number](Def &def) { def.z_near = number; });
    for (const float number : {0.1f, NAN, INFINITY}) looks(perspective, [number](Def &def) { def.z_far = number; });
    looks("the same point, or not finite", [](Def &def) { def.target[2] = 0; });
    looks("the same point, or not finite", [](Def &def) { def.eye[1] = NAN; });
    looks("the same point, or not finite", [](Def &def) { def.target[0] = INFINITY; });
    looks("up lies along the line of sight", [](Def &def) { def.up[1] = 0, def.up[2] = 3; });
    looks("narrower than a projection's numbers reach", [](Def &def) { def.fov_y_rad = 1e-39f; });
    looks("narrower than a projection's numbers reach", [](Def &def) { def.aspect = 1e-39f; });
}

}  // namespace
