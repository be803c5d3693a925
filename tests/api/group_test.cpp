// Groups through the C API: a platform that carries its passengers and can be disabled.
#include <claque/claque.h>

#include <vector>

#include <gtest/gtest.h>

#include "tests/api/calls.h"
#include "tests/api/small_template.h"

namespace
{

class GroupApi : public testing::Test
{
protected:
    void SetUp() override
    {
        ASSERT_EQ(clq_context_create(nullptr, &context_), CLQ_OK);
        ASSERT_EQ(clq_template_build(context_, &small_.def, &tmpl_), CLQ_OK);
        ASSERT_EQ(clq_crowd_create(context_, nullptr, &crowd_), CLQ_OK);
        for (int i = 0; i < 6; ++i) {
            clq_actor_def def = clq_actor_def_init();
            def.tmpl = tmpl_;
            def.transform.position[0] = i - 2.5;
            def.transform.position[2] = -10;
            clq_actor actor;
            ASSERT_EQ(clq_actor_create(crowd_, &def, &actor), CLQ_OK);
            actors_.push_back(actor);
        }
        ASSERT_EQ(clq_view_create(crowd_, &view_), CLQ_OK);
        clq_camera camera;
        const double eye[3] = {0, 1, 0}, target[3] = {0, 1, -10};
        const float up[3] = {0, 1, 0};
        ASSERT_EQ(api_test::look_at(&camera, eye, target, up, 0.9f, 1.3f, 0.1f, 100), CLQ_OK);
        ASSERT_EQ(clq_view_set_camera(view_, &camera), CLQ_OK);
    }
    void TearDown() override
    {
        clq_crowd_destroy(crowd_);
        clq_template_destroy(tmpl_);
        clq_context_destroy(context_);
    }
    uint32_t seen(double time_s)
    {
        EXPECT_EQ(clq_crowd_update(crowd_, time_s, &view_, 1), CLQ_OK);
        clq_view_stats stats = clq_view_stats_init();
        EXPECT_EQ(clq_view_get_stats(view_, &stats), CLQ_OK);
        return stats.visible;
    }
    clq_group_info info(clq_group group)
    {
        clq_group_info out = clq_group_info_init();
        EXPECT_EQ(clq_group_get_info(crowd_, group, &out), CLQ_OK);
        return out;
    }

    SmallTemplate small_;
    clq_context *context_ = nullptr;
    clq_template *tmpl_ = nullptr;
    clq_crowd *crowd_ = nullptr;
    clq_view *view_ = nullptr;
    std::vector<clq_actor> actors_;
};

}  // namespace

TEST_F(GroupApi, CarriesItsMembersOutOfViewAndBack)
{
    clq_transform transform = {{0, 0, -10}, {0, 0, 0, 1}, 1};
    clq_group group;
    ASSERT_EQ(clq_group_create(crowd_, &transform, &group), CLQ_OK);
    for (int i = 0; i < 4; ++i) ASSERT_EQ(clq_actor_join(crowd_, actors_[i], group, nullptr), CLQ_OK);
    EXPECT_EQ(info(group).member_count, 4u);
    EXPECT_EQ(seen(1), 6u);
    EXPECT_TRUE(info(group).visible);
    transform.position[2] = 500;
    ASSERT_EQ(clq_group_set_transform(crowd_, group, &transform), CLQ_OK);
    EXPECT_EQ(seen(2), 2u);
    EXPECT_FALSE(info(group).visible);
    clq_crowd_stats stats = clq_crowd_stats_init();
    ASSERT_EQ(clq_crowd_get_stats(crowd_, &stats), CLQ_OK);
    EXPECT_EQ(stats.groups, 1u);
    EXPECT_EQ(stats.groups_visible, 0u);
    EXPECT_EQ(stats.tested, 2u);
    clq_actor_info member = clq_actor_info_init();
    ASSERT_EQ(clq_actor_get_info(crowd_, actors_[0], &member), CLQ_OK);
    EXPECT_EQ(member.group.index1, group.index1);
    EXPECT_NEAR(member.transform.position[2], 0, 1e-6) << "in the group's space";
    EXPECT_FALSE(member.visible);
    transform.position[2] = -10;
    ASSERT_EQ(clq_group_set_transform(crowd_, group, &transform), CLQ_OK);
    EXPECT_EQ(seen(3), 6u);
    ASSERT_EQ(clq_group_set_enabled(crowd_, group, 0), CLQ_OK);
    EXPECT_EQ(seen(4), 2u);
    EXPECT_FALSE(info(group).enabled);
    ASSERT_EQ(clq_group_destroy(crowd_, group), CLQ_OK);
    EXPECT_EQ(seen(5), 6u) << "members of a disabled group are visible once the group is destroyed";
}

TEST_F(GroupApi, RefusesInOneSentence)
{
    clq_group group, none = {0, 0};
    ASSERT_EQ(clq_group_create(crowd_, nullptr, &group), CLQ_OK);
    EXPECT_EQ(clq_group_create(nullptr, nullptr, &group), CLQ_ARGUMENT);
    EXPECT_EQ(clq_group_create(crowd_, nullptr, nullptr), CLQ_ARGUMENT);
    const clq_transform huge = {{0, 0, 0}, {0, 0, 0, 1}, 1e9f};
    EXPECT_EQ(clq_group_set_transform(crowd_, group, &huge), CLQ_ARGUMENT);
    EXPECT_NE(std::string(clq_last_error()).find("1e+09"), std::string::npos) << clq_last_error();
    EXPECT_EQ(clq_group_set_transform(crowd_, group, nullptr), CLQ_ARGUMENT);
    EXPECT_EQ(clq_group_set_transform(crowd_, none, &huge), CLQ_ARGUMENT);
    EXPECT_EQ(clq_group_set_enabled(crowd_, none, 1), CLQ_STALE_ID);
    EXPECT_EQ(clq_group_destroy(crowd_, none), CLQ_STALE_ID);
    EXPECT_EQ(clq_actor_join(crowd_, actors_[0], {7, 7}, nullptr), CLQ_STALE_ID);
    EXPECT_EQ(clq_actor_join(crowd_, {7, 7}, group, nullptr), CLQ_STALE_ID);
    clq_group_info out = clq_group_info_init();
    EXPECT_EQ(clq_group_get_info(crowd_, none, &out), CLQ_STALE_ID);
    ASSERT_EQ(clq_group_destroy(crowd_, group), CLQ_OK);
    EXPECT_EQ(clq_group_destroy(crowd_, group), CLQ_STALE_ID);
}
