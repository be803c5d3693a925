// Edge cases of the C API: reused rows, lists that are drawn late, tasks that call back, values just outside their
// limits.
#include <claque/claque.h>

#include <cstring>
#include <limits>
#include <string>

#include <gtest/gtest.h>

#include "tests/api/calls.h"
#include "tests/api/small_template.h"

namespace
{

struct Calls {
    clq_crowd *crowd = nullptr;
    clq_status reset = CLQ_OK;
};

// A host whose tasks make calls that tasks must not make.
void run_and_meddle(void *user, uint32_t count, void (*job)(void *, uint32_t), void *data)
{
    Calls &calls = *static_cast<Calls *>(user);
    calls.reset = clq_crowd_reset_bands(calls.crowd);
    for (uint32_t i = 0; i < count; ++i) job(data, i);
}

class Edge : public testing::Test
{
protected:
    void SetUp() override
    {
        clq_context_def def = clq_context_def_init();
        def.tasks = {&calls_, run_and_meddle};
        ASSERT_EQ(clq_context_create(&def, &context_), CLQ_OK);
        ASSERT_EQ(clq_template_build(context_, &small_.def, &tmpl_), CLQ_OK) << clq_last_error();
        ASSERT_EQ(clq_crowd_create(context_, nullptr, &crowd_), CLQ_OK);
        ASSERT_EQ(clq_view_create(crowd_, &view_), CLQ_OK);
        calls_.crowd = crowd_;
        clq_camera camera;
        const double eye[3] = {0, 1, 6}, target[3] = {0, 1, 0};
        const float up[3] = {0, 1, 0};
        ASSERT_EQ(api_test::look_at(&camera, eye, target, up, 0.8f, 1.33f, 0.1f, 100), CLQ_OK);
        ASSERT_EQ(clq_view_set_camera(view_, &camera), CLQ_OK);
    }
    void TearDown() override
    {
        clq_crowd_destroy(crowd_);
        clq_template_destroy(tmpl_);
        EXPECT_EQ(clq_context_destroy(context_), CLQ_OK) << clq_last_error();
    }
    clq_actor add(double x)
    {
        clq_actor_def def = clq_actor_def_init();
        def.tmpl = tmpl_;
        def.play.clip = 0;
        def.transform.position[0] = x;
        clq_actor actor = {0, 0};
        EXPECT_EQ(clq_actor_create(crowd_, &def, &actor), CLQ_OK) << clq_last_error();
        return actor;
    }
    void colour(clq_actor actor, float red)
    {
        const float rgb[6] = {red, 0, 0, red, 0, 0};
        EXPECT_EQ(clq_actor_set_colours(crowd_, actor, rgb, 2), CLQ_OK) << clq_last_error();
    }
    clq_status build() const
    {
        clq_template *tmpl = nullptr;
        const clq_status status = clq_template_build(context_, &small_.def, &tmpl);
        clq_template_destroy(tmpl);
        return status;
    }

    SmallTemplate small_;
    Calls calls_;
    clq_context *context_ = nullptr;
    clq_template *tmpl_ = nullptr;
    clq_crowd *crowd_ = nullptr;
    clq_view *view_ = nullptr;
};

const double far_away = 1e6;
const float nan_edge = std::numeric_limits<float>::quiet_NaN();

}  // namespace

TEST_F(Edge, ANewActorHasNotBeenVisibleEvenInAReusedRow)
{
    const clq_actor first = add(0);
    ASSERT_EQ(clq_crowd_update(crowd_, 1.5, &view_, 1), CLQ_OK);
    ASSERT_EQ(clq_actor_destroy(crowd_, first), CLQ_OK);
    const clq_actor second = add(far_away);
    ASSERT_EQ(second.index1, first.index1) << "the row must be reused, otherwise this test shows nothing";
    ASSERT_EQ(clq_crowd_update(crowd_, 2.0, &view_, 1), CLQ_OK);
    clq_actor_info info = clq_actor_info_init();
    ASSERT_EQ(clq_actor_get_info(crowd_, second, &info), CLQ_OK);
    EXPECT_EQ(info.visible, 0);
    EXPECT_EQ(info.period_s, 0.0f);
    EXPECT_EQ(info.tick_s, 0.0);
}

TEST_F(Edge, AListKeepsTheColoursThatItsUpdateFound)
{
    const clq_actor actor = add(0);
    colour(actor, 1);
    ASSERT_EQ(clq_crowd_update(crowd_, 1.5, &view_, 1), CLQ_OK);
    const uint64_t list = clq_view_get_hash(view_);
    colour(actor, 0.5f);
    EXPECT_EQ(clq_view_get_hash(view_), list) << "colours set after the update";
    ASSERT_EQ(clq_actor_destroy(crowd_, actor), CLQ_OK);
    for (int i = 0; i < 600; ++i) colour(add(far_away), 0.25f);
    EXPECT_EQ(clq_view_get_hash(view_), list) << "another individual took over the memory";
    ASSERT_NE(clq_crowd_update(crowd_, std::numeric_limits<double>::infinity(), &view_, 1), CLQ_OK);
    EXPECT_EQ(clq_view_get_hash(view_), list) << "an update that failed";
    const clq_actor again = add(0);
    colour(again, 0.5f);
    ASSERT_EQ(clq_crowd_update(crowd_, 1.5, &view_, 1), CLQ_OK);
    EXPECT_NE(clq_view_get_hash(view_), list) << "the next update shows them";
}

TEST_F(Edge, CountersCannotBeResetByATaskOfAnUpdate)
{
    add(0);
    ASSERT_EQ(clq_crowd_update(crowd_, 1.5, &view_, 1), CLQ_OK);
    EXPECT_EQ(calls_.reset, CLQ_BUSY);
    EXPECT_EQ(clq_crowd_reset_bands(crowd_), CLQ_OK);
}

TEST_F(Edge, ZonesOutsideTheirLimitsAreRefusedWhenTheyAreGiven)
{
    const clq_zone_def good = small_.zones[0];
    for (const float bad : {-0.5f, 2.0f, nan_edge}) {
        small_.zones[0].colour[1] = bad;
        EXPECT_EQ(build(), CLQ_ARGUMENT) << "colour " << bad;
        EXPECT_NE(std::string(clq_last_error()).find("cloth"), std::string::npos) << clq_last_error();
        small_.zones[0] = good;
        small_.zones[0].range.brightness_max = bad;
        EXPECT_EQ(build(), CLQ_ARGUMENT) << "brightness " << bad;
        small_.zones[0] = good;
    }
    small_.zones[0].range.hue_min_deg = 361;
    EXPECT_EQ(build(), CLQ_ARGUMENT);
    small_.zones[0] = good;
    EXPECT_EQ(build(), CLQ_OK) << clq_last_error();
}

TEST_F(Edge, AJointBeyondTheHostsOwnIsRefusedBesideRigidPartsToo)
{
    // A rigid part adds a matrix of its own, at the index where joint 2 would be.
    clq_part_def parts[2] = {small_.parts[0], small_.parts[0]};
    uint32_t joints[20];
    std::memcpy(joints, small_.parts[0].joints, sizeof joints);
    parts[0].joints = joints;
    parts[1].influence_count = 0;
    parts[1].joints = nullptr;
    parts[1].weights = nullptr;
    parts[1].node = 1;
    small_.def.part_count = 2;
    small_.def.parts = parts;
    EXPECT_EQ(build(), CLQ_OK) << clq_last_error();
    joints[3] = 2;
    EXPECT_EQ(build(), CLQ_ARGUMENT);
    EXPECT_NE(std::string(clq_last_error()).find("joint 2, which does not exist: there are 2"), std::string::npos)
        << clq_last_error();
}

TEST_F(Edge, ARotationThatWouldScaleItsNodeIsRefused)
{
    float *q = small_.nodes[1].rotation_xyzw;
    q[1] = 0.6f, q[3] = 0.8f;
    EXPECT_EQ(build(), CLQ_OK) << clq_last_error();
    q[3] = 0.9f;
    EXPECT_EQ(build(), CLQ_ARGUMENT);
    EXPECT_NE(std::string(clq_last_error()).find("tip"), std::string::npos) << clq_last_error();
    q[3] = nan_edge;
    EXPECT_EQ(build(), CLQ_ARGUMENT);
    q[1] = q[3] = 0;
    EXPECT_EQ(build(), CLQ_OK) << "all zero means none";
}

TEST_F(Edge, MaterialsThatAreNoNumbersAreRefused)
{
    small_.materials[0].base_colour[2] = nan_edge;
    EXPECT_EQ(build(), CLQ_ARGUMENT);
    small_.materials[0].base_colour[2] = 0;
    small_.materials[0].alpha_cutoff = std::numeric_limits<float>::infinity();
    EXPECT_EQ(build(), CLQ_ARGUMENT);
    small_.materials[0].alpha_cutoff = 0.5f;
    EXPECT_EQ(build(), CLQ_OK) << clq_last_error();
}

TEST_F(Edge, AViewTooNarrowForItsProjectionIsRefused)
{
    clq_camera camera;
    const double eye[3] = {0, 1, 6}, target[3] = {0, 1, 0};
    const float up[3] = {0, 1, 0};
    EXPECT_EQ(api_test::look_at(&camera, eye, target, up, 1e-44f, 1, 0.1f, 100), CLQ_ARGUMENT);
    EXPECT_EQ(api_test::look_at(&camera, eye, target, up, 1, 1e-42f, 0.1f, 100), CLQ_ARGUMENT);
    ASSERT_EQ(api_test::look_at(&camera, eye, target, up, 1e-6f, 1, 0.1f, 100), CLQ_OK) << clq_last_error();
    EXPECT_EQ(clq_view_set_camera(view_, &camera), CLQ_OK) << clq_last_error();
}

TEST_F(Edge, AnActorFartherThanFloatReachesHasTheLongestPeriod)
{
    clq_crowd_def def = clq_crowd_def_init();
    def.period_near_s = def.period_far_s = 0.1f;
    clq_crowd_destroy(crowd_);
    crowd_ = nullptr;
    ASSERT_EQ(clq_crowd_create(context_, &def, &crowd_), CLQ_OK);
    ASSERT_EQ(clq_view_create(crowd_, &view_), CLQ_OK);
    calls_.crowd = crowd_;
    clq_camera camera = {};  // a perspective without a far plane
    camera.rotation_xyzw[3] = camera.projection[0] = camera.projection[5] = 1;
    camera.projection[10] = camera.projection[11] = -1, camera.projection[14] = -0.2f;
    ASSERT_EQ(clq_view_set_camera(view_, &camera), CLQ_OK) << clq_last_error();
    const clq_actor actor = add(0);
    const clq_transform transform = {{0, 0, -1e100}, {0, 0, 0, 1}, 1};
    ASSERT_EQ(clq_crowd_set_transforms(crowd_, &actor, &transform, 1), CLQ_OK);
    ASSERT_EQ(clq_crowd_update(crowd_, 1.5, &view_, 1), CLQ_OK);
    clq_actor_info info = clq_actor_info_init();
    ASSERT_EQ(clq_actor_get_info(crowd_, actor, &info), CLQ_OK);
    ASSERT_EQ(info.visible, 1);
    EXPECT_NEAR(info.period_s, 0.1f, 1e-6f);
}
