// Wrong arguments give a status and a sentence with names and numbers, and change nothing.
#include <claque/claque.h>

#include <cmath>
#include <limits>
#include <string>

#include <gtest/gtest.h>

#include "tests/api/calls.h"
#include "tests/api/small_template.h"

namespace
{

class Arguments : public testing::Test
{
protected:
    void SetUp() override
    {
        ASSERT_EQ(clq_context_create(nullptr, &context_), CLQ_OK);
        ASSERT_EQ(clq_template_build(context_, &small_.def, &tmpl_), CLQ_OK) << clq_last_error();
        ASSERT_EQ(clq_crowd_create(context_, nullptr, &crowd_), CLQ_OK);
        clq_actor_def def = clq_actor_def_init();
        def.tmpl = tmpl_;
        ASSERT_EQ(clq_actor_create(crowd_, &def, &actor_), CLQ_OK);
        ASSERT_EQ(clq_view_create(crowd_, &view_), CLQ_OK);
    }
    void TearDown() override
    {
        clq_crowd_destroy(crowd_);
        clq_template_destroy(tmpl_);
        EXPECT_EQ(clq_context_destroy(context_), CLQ_OK) << clq_last_error();
    }
    bool mentions(const char *word) const { return std::string(clq_last_error()).find(word) != std::string::npos; }

    SmallTemplate small_;
    clq_context *context_ = nullptr;
    clq_template *tmpl_ = nullptr;
    clq_crowd *crowd_ = nullptr;
    clq_view *view_ = nullptr;
    clq_actor actor_ = {0, 0};
};

const float nan_argument = std::numeric_limits<float>::quiet_NaN();

}  // namespace

TEST_F(Arguments, NullPointersAreRefusedByEveryCall)
{
    clq_template *tmpl = nullptr;
    clq_crowd *crowd = nullptr;
    clq_actor actor;
    clq_view *view = nullptr;
    clq_camera camera;
    EXPECT_EQ(clq_context_create(nullptr, nullptr), CLQ_ARGUMENT);
    EXPECT_EQ(clq_template_build(nullptr, &small_.def, &tmpl), CLQ_ARGUMENT);
    EXPECT_EQ(clq_template_build(context_, nullptr, &tmpl), CLQ_ARGUMENT);
    EXPECT_EQ(clq_template_build(context_, &small_.def, nullptr), CLQ_ARGUMENT);
    EXPECT_EQ(clq_template_save(nullptr, nullptr, nullptr), CLQ_ARGUMENT);
    EXPECT_EQ(clq_template_load(context_, nullptr, 10, &tmpl), CLQ_ARGUMENT);
    EXPECT_EQ(clq_template_get_info(nullptr, nullptr), CLQ_ARGUMENT);
    EXPECT_EQ(clq_crowd_create(nullptr, nullptr, &crowd), CLQ_ARGUMENT);
    EXPECT_EQ(clq_crowd_update(nullptr, 0, nullptr, 0), CLQ_ARGUMENT);
    EXPECT_EQ(clq_crowd_update(crowd_, 0, nullptr, 1), CLQ_ARGUMENT);
    EXPECT_EQ(clq_crowd_set_transforms(crowd_, nullptr, nullptr, 1), CLQ_ARGUMENT);
    EXPECT_EQ(clq_crowd_get_stats(crowd_, nullptr), CLQ_ARGUMENT);
    EXPECT_EQ(clq_actor_create(crowd_, nullptr, &actor), CLQ_ARGUMENT);
    EXPECT_EQ(clq_actor_play(crowd_, actor_, nullptr), CLQ_ARGUMENT);
    EXPECT_EQ(clq_actor_set_colours(crowd_, actor_, nullptr, 2), CLQ_ARGUMENT);
    EXPECT_EQ(clq_actor_get_info(crowd_, actor_, nullptr), CLQ_ARGUMENT);
    EXPECT_EQ(clq_view_create(nullptr, &view), CLQ_ARGUMENT);
    EXPECT_EQ(clq_view_set_camera(view_, nullptr), CLQ_ARGUMENT);
    EXPECT_EQ(clq_camera_look_at(nullptr, &camera), CLQ_ARGUMENT);
    EXPECT_EQ(clq_renderer_create(context_, nullptr, nullptr), CLQ_ARGUMENT);
    EXPECT_EQ(clq_renderer_draw(nullptr, view_, nullptr), CLQ_ARGUMENT);
    EXPECT_EQ(clq_renderer_draw_shadows(nullptr, view_, nullptr, nullptr), CLQ_ARGUMENT);
    EXPECT_EQ(clq_renderer_draw_visibility(nullptr, view_, nullptr, nullptr), CLQ_ARGUMENT);
    EXPECT_EQ(clq_view_get_pixels(view_, nullptr, nullptr), CLQ_ARGUMENT);
    EXPECT_EQ(clq_view_get_flow(view_, nullptr, nullptr, nullptr), CLQ_ARGUMENT);
    EXPECT_EQ(clq_template_find_clip(nullptr, "bend"), CLQ_NONE);
    clq_crowd_destroy(nullptr), clq_template_destroy(nullptr), clq_renderer_destroy(nullptr), clq_view_destroy(nullptr);
    EXPECT_EQ(clq_context_destroy(nullptr), CLQ_OK);
}

TEST_F(Arguments, ADefOfAnotherSizeIsNamed)
{
    clq_actor_def def = clq_actor_def_init();
    def.struct_bytes -= 4;
    clq_actor actor;
    EXPECT_EQ(clq_actor_create(crowd_, &def, &actor), CLQ_STRUCT_SIZE);
    EXPECT_TRUE(mentions("clq_actor_def_init"));
    clq_crowd_def crowd_def = clq_crowd_def_init();
    crowd_def.struct_bytes = 0;
    clq_crowd *crowd;
    EXPECT_EQ(clq_crowd_create(context_, &crowd_def, &crowd), CLQ_STRUCT_SIZE);
}

TEST_F(Arguments, ACloseDistanceThatIsNoDistanceIsRefused)
{
    clq_renderer_def def = clq_renderer_def_init();
    def.get_proc_address = [](void *, const char *) -> clq_gl_function { return nullptr; };
    clq_renderer *renderer = nullptr;
    for (const float distance : {-1.0f, NAN, INFINITY}) {
        def.close_distance_m = distance;
        EXPECT_EQ(clq_renderer_create(context_, &def, &renderer), CLQ_ARGUMENT) << distance;
        EXPECT_TRUE(mentions("close_distance_m"));
    }
    def.close_distance_m = 0;
    EXPECT_EQ(clq_renderer_create(context_, &def, &renderer), CLQ_GL_MISSING);
}

TEST_F(Arguments, CrowdSettingsOutsideTheirLimitsAreRefused)
{
    clq_crowd *crowd;
    clq_crowd_def def = clq_crowd_def_init();
    def.period_far_s = 0.01f;  // below period_near_s
    EXPECT_EQ(clq_crowd_create(context_, &def, &crowd), CLQ_ARGUMENT);
    def = clq_crowd_def_init();
    def.distance_far_m = def.distance_near_m;
    EXPECT_EQ(clq_crowd_create(context_, &def, &crowd), CLQ_ARGUMENT);
    def = clq_crowd_def_init();
    def.period_near_s = nan_argument;
    EXPECT_EQ(clq_crowd_create(context_, &def, &crowd), CLQ_ARGUMENT);
    def = clq_crowd_def_init();
    def.cache = static_cast<clq_cache_mode>(7);
    EXPECT_EQ(clq_crowd_create(context_, &def, &crowd), CLQ_ARGUMENT);
}

TEST_F(Arguments, ABudgetIsRefusedWhereNoActorMayWaitOrNothingIsKept)
{
    clq_crowd *crowd = nullptr;
    clq_crowd_def def = clq_crowd_def_init();
    def.update_budget = 10;
    EXPECT_EQ(clq_crowd_create(context_, &def, &crowd), CLQ_ARGUMENT);
    EXPECT_TRUE(mentions("CLQ_CLOCK_LIVE"));
    def.clock = CLQ_CLOCK_LIVE;
    def.cache = CLQ_CACHE_NONE;
    EXPECT_EQ(clq_crowd_create(context_, &def, &crowd), CLQ_ARGUMENT);
    EXPECT_TRUE(mentions("CLQ_CACHE_NONE"));
    def.cache = CLQ_CACHE_FULL;
    def.update_budget_ms = 2;
    EXPECT_EQ(clq_crowd_create(context_, &def, &crowd), CLQ_ARGUMENT);
    EXPECT_TRUE(mentions("now_s"));
    def.update_budget_ms = nan_argument;
    EXPECT_EQ(clq_crowd_create(context_, &def, &crowd), CLQ_ARGUMENT);
    def.update_budget_ms = 0;
    def.vertex_format = static_cast<clq_vertex_format>(2);
    EXPECT_EQ(clq_crowd_create(context_, &def, &crowd), CLQ_ARGUMENT);
    def.vertex_format = CLQ_VERTEX_PACKED;
    ASSERT_EQ(clq_crowd_create(context_, &def, &crowd), CLQ_OK) << clq_last_error();
    clq_crowd_destroy(crowd);
}

TEST_F(Arguments, AStaleOrInventedIdIsAnErrorAndChangesNothing)
{
    const clq_actor invented[] = {{0, 0}, {2, 1}, {1, 99}, {0xffffffffu, 1}};
    clq_play play = {0, 0, 1, 0};
    clq_transform transform = {{0, 0, 0}, {0, 0, 0, 1}, 1};
    clq_actor_info info = clq_actor_info_init();
    const uint64_t before = clq_crowd_get_hash(crowd_);
    for (const clq_actor &actor : invented) {
        EXPECT_EQ(clq_actor_play(crowd_, actor, &play), CLQ_STALE_ID);
        EXPECT_EQ(clq_crowd_set_transforms(crowd_, &actor, &transform, 1), CLQ_STALE_ID);
        EXPECT_EQ(clq_actor_randomise_colours(crowd_, actor, nullptr, 0), CLQ_STALE_ID);
        EXPECT_EQ(clq_actor_get_info(crowd_, actor, &info), CLQ_STALE_ID);
        EXPECT_EQ(clq_actor_destroy(crowd_, actor), CLQ_STALE_ID);
    }
    EXPECT_EQ(clq_crowd_get_hash(crowd_), before);
    EXPECT_EQ(clq_actor_destroy(crowd_, actor_), CLQ_OK);
    EXPECT_EQ(clq_actor_destroy(crowd_, actor_), CLQ_STALE_ID);
    clq_actor_def def = clq_actor_def_init();
    def.tmpl = tmpl_;
    clq_actor again;
    ASSERT_EQ(clq_actor_create(crowd_, &def, &again), CLQ_OK);
    EXPECT_EQ(clq_actor_play(crowd_, actor_, &play), CLQ_STALE_ID) << "the row is reused, the old id stays stale";
}

TEST_F(Arguments, SettingTransformsIsAllOrNothing)
{
    clq_actor_def def = clq_actor_def_init();
    def.tmpl = tmpl_;
    clq_actor other;
    ASSERT_EQ(clq_actor_create(crowd_, &def, &other), CLQ_OK);
    const uint64_t before = clq_crowd_get_hash(crowd_);
    const clq_actor actors[2] = {actor_, other};
    clq_transform places[2] = {{{1, 2, 3}, {0, 0, 0, 1}, 1}, {{1, 2, 3}, {0, 0, 0, 1}, nan_argument}};
    EXPECT_EQ(clq_crowd_set_transforms(crowd_, actors, places, 2), CLQ_ARGUMENT);
    EXPECT_EQ(clq_crowd_get_hash(crowd_), before);
    places[1].scale = 1;
    places[1].orientation_xyzw[0] = 3;
    EXPECT_EQ(clq_crowd_set_transforms(crowd_, actors, places, 2), CLQ_ARGUMENT);
    places[1].orientation_xyzw[0] = 0;
    places[1].position[1] = std::numeric_limits<double>::infinity();
    EXPECT_EQ(clq_crowd_set_transforms(crowd_, actors, places, 2), CLQ_ARGUMENT);
    EXPECT_EQ(clq_crowd_get_hash(crowd_), before);
    places[1].position[1] = 0;
    EXPECT_EQ(clq_crowd_set_transforms(crowd_, actors, places, 2), CLQ_OK);
    EXPECT_NE(clq_crowd_get_hash(crowd_), before);
}

TEST_F(Arguments, ClipsAndColoursOfAnotherTemplateAreRefused)
{
    clq_play play = {1, 0, 1, 0};
    EXPECT_EQ(clq_actor_play(crowd_, actor_, &play), CLQ_ARGUMENT);
    EXPECT_TRUE(mentions("strip")) << clq_last_error();
    play = {0, 0, nan_argument, 0};
    EXPECT_EQ(clq_actor_play(crowd_, actor_, &play), CLQ_ARGUMENT);
    const float rgb[9] = {0, 0, 0, 1, 1, 1, 0, 0, 0};
    EXPECT_EQ(clq_actor_set_colours(crowd_, actor_, rgb, 3), CLQ_ARGUMENT);
    EXPECT_EQ(clq_actor_set_colours(crowd_, actor_, rgb, 2), CLQ_OK);
    const float wrong[6] = {0, 0, 1.5f, 0, 0, 0};
    EXPECT_EQ(clq_actor_set_colours(crowd_, actor_, wrong, 2), CLQ_ARGUMENT);
}

TEST_F(Arguments, CamerasThatSeeNothingAreRefused)
{
    clq_camera camera;
    const double eye[3] = {0, 0, 0}, target[3] = {0, 1, 0}, ahead[3] = {0, 0, -1};
    const float up[3] = {0, 1, 0};
    EXPECT_EQ(api_test::look_at(&camera, eye, target, up, 1, 1, 0.1f, 10), CLQ_ARGUMENT)
        << "up along the line of sight";
    EXPECT_EQ(api_test::look_at(&camera, eye, eye, up, 1, 1, 0.1f, 10), CLQ_ARGUMENT);
    EXPECT_EQ(api_test::look_at(&camera, eye, ahead, up, 4, 1, 0.1f, 10), CLQ_ARGUMENT);
    EXPECT_EQ(api_test::look_at(&camera, eye, ahead, up, 1, 1, 10, 0.1f), CLQ_ARGUMENT);
    ASSERT_EQ(api_test::look_at(&camera, eye, ahead, up, 1, 1, 0.1f, 10), CLQ_OK);
    EXPECT_EQ(clq_view_set_camera(view_, &camera), CLQ_OK);
    camera.projection[0] = nan_argument;
    EXPECT_EQ(clq_view_set_camera(view_, &camera), CLQ_ARGUMENT);
    EXPECT_EQ(clq_crowd_update(crowd_, std::nan(""), &view_, 1), CLQ_ARGUMENT);
}

TEST_F(Arguments, WhatIsStillNeededOutlivesItsDestroy)
{
    EXPECT_EQ(clq_context_destroy(context_), CLQ_IN_USE);
    clq_template_destroy(tmpl_);  // the crowd still holds it
    tmpl_ = nullptr;
    EXPECT_EQ(clq_crowd_update(crowd_, 0, &view_, 1), CLQ_OK) << clq_last_error();
    clq_actor_info info = clq_actor_info_init();
    ASSERT_EQ(clq_actor_get_info(crowd_, actor_, &info), CLQ_OK);
    clq_template_info template_info = clq_template_info_init();
    EXPECT_EQ(clq_template_get_info(info.tmpl, &template_info), CLQ_OK);
    EXPECT_STREQ(template_info.name, "strip");
}

TEST_F(Arguments, StatusesHaveNames)
{
    EXPECT_STREQ(clq_status_name(CLQ_STALE_ID), "CLQ_STALE_ID");
    EXPECT_STREQ(clq_status_name(CLQ_IO), "CLQ_IO");
    EXPECT_STREQ(clq_status_name(static_cast<clq_status>(99)), "CLQ_?");
    EXPECT_EQ(clq_report(CLQ_IO, "as told"), CLQ_IO);
    EXPECT_STREQ(clq_last_error(), "as told");
}
