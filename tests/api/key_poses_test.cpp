// Shared key-poses through the C API: refusals, with names and numbers, and counters.
#include <claque/claque.h>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/api/calls.h"
#include "tests/api/small_template.h"

namespace
{

class KeyPoses : public testing::Test
{
protected:
    void SetUp() override
    {
        ASSERT_EQ(clq_context_create(nullptr, &context_), CLQ_OK);
        ASSERT_EQ(clq_template_build(context_, &small_.def, &tmpl_), CLQ_OK) << clq_last_error();
    }
    void TearDown() override
    {
        clq_crowd_destroy(crowd_);
        clq_template_destroy(tmpl_);
        EXPECT_EQ(clq_context_destroy(context_), CLQ_OK) << clq_last_error();
    }
    bool mentions(const char *word) const { return std::string(clq_last_error()).find(word) != std::string::npos; }

    clq_status create(const clq_key_poses &key_poses)
    {
        clq_crowd_def def = clq_crowd_def_init();
        def.key_poses = key_poses;
        clq_crowd_destroy(crowd_);
        crowd_ = nullptr;
        return clq_crowd_create(context_, &def, &crowd_);
    }

    // A row of individuals, each at another phase of one clip, in a number of views from one position.
    void stand(uint32_t count, uint32_t view_count)
    {
        for (uint32_t i = 0; i < count; ++i) {
            clq_actor_def def = clq_actor_def_init();
            def.tmpl = tmpl_;
            def.transform.position[0] = 0.1 * i;
            def.play.clip = clq_template_find_clip(tmpl_, "bend");
            def.play.phase_s = static_cast<float>(i) / static_cast<float>(count);
            clq_actor actor;
            ASSERT_EQ(clq_actor_create(crowd_, &def, &actor), CLQ_OK) << clq_last_error();
        }
        const double eye[] = {0, 1, 20}, target[] = {0, 1, 0};
        const float up[] = {0, 1, 0};
        clq_camera camera;
        ASSERT_EQ(api_test::look_at(&camera, eye, target, up, 1.0f, 1.5f, 0.5f, 100.0f), CLQ_OK);
        views_.resize(view_count);
        for (clq_view *&view : views_) {
            ASSERT_EQ(clq_view_create(crowd_, &view), CLQ_OK);
            ASSERT_EQ(clq_view_set_camera(view, &camera), CLQ_OK);
        }
    }
    clq_key_pose_stats update(double time_s)
    {
        EXPECT_EQ(clq_crowd_update(crowd_, time_s, views_.data(), static_cast<uint32_t>(views_.size())), CLQ_OK)
            << clq_last_error();
        clq_key_pose_stats stats = clq_key_pose_stats_init();
        EXPECT_EQ(clq_crowd_get_key_pose_stats(crowd_, &stats), CLQ_OK);
        return stats;
    }

    SmallTemplate small_;
    clq_context *context_ = nullptr;
    clq_template *tmpl_ = nullptr;
    clq_crowd *crowd_ = nullptr;
    std::vector<clq_view *> views_;  // of the crowd
};

const float nan_value = std::numeric_limits<float>::quiet_NaN(), infinite = std::numeric_limits<float>::infinity();

clq_key_poses whole_crowd(clq_key_pose_mode method)
{
    clq_key_poses key_poses = clq_key_poses_init();
    key_poses.bands[0].mode = method;
    key_poses.band_count = 1;
    return key_poses;
}

}  // namespace

TEST_F(KeyPoses, AreNotShownUnlessRequested)
{
    ASSERT_EQ(create(clq_key_poses_init()), CLQ_OK) << clq_last_error();
    stand(10, 1);
    const clq_key_pose_stats stats = update(1);
    EXPECT_EQ(stats.requested, 0u);
    EXPECT_EQ(stats.bytes, 0u);
}

TEST_F(KeyPoses, OfInvalidRatesAndBandsAreRefusedWithTheNumber)
{
    const auto refused = [&](const clq_key_poses &key_poses, const char *name, const char *number) {
        EXPECT_EQ(create(key_poses), CLQ_ARGUMENT);
        EXPECT_EQ(crowd_, nullptr) << "written only on success";
        EXPECT_TRUE(mentions(name) && mentions(number)) << clq_last_error();
    };
    for (const float rate : {0.4f, 121.0f, -1.0f, infinite, nan_value}) {
        clq_key_poses key_poses = clq_key_poses_init();
        key_poses.rate_hz = rate;
        refused(key_poses, "rate_hz", "0.5 to 120");
    }
    clq_key_poses key_poses = clq_key_poses_init();
    key_poses.band_count = CLQ_KEY_POSE_BAND_MAX + 1;
    refused(key_poses, "5 bands", "4");
    for (const float distance : {-1.0f, infinite, nan_value}) {
        key_poses = whole_crowd(CLQ_KEY_POSE_INTERMITTENT);
        key_poses.bands[0].distance_min_m = distance;
        refused(key_poses, "bands[0].distance_min_m", "0 or more");
    }
    for (const float second : {5.0f, 4.0f, nan_value}) {
        key_poses = whole_crowd(CLQ_KEY_POSE_INTERPOLATED);
        key_poses.bands[0].distance_min_m = 5;
        key_poses.bands[1].distance_min_m = second;
        key_poses.bands[1].mode = CLQ_KEY_POSE_INTERMITTENT;
        key_poses.band_count = 2;
        refused(key_poses, "bands[1].distance_min_m", "before");
    }
    key_poses = whole_crowd(static_cast<clq_key_pose_mode>(CLQ_KEY_POSE_SKINNED + 1));
    refused(key_poses, "bands[0].mode", "4");
}

TEST_F(KeyPoses, AtTheLimitsAreAccepted)
{
    for (const float rate : {0.5f, 120.0f}) {
        clq_key_poses key_poses = whole_crowd(CLQ_KEY_POSE_INTERPOLATED);
        key_poses.rate_hz = rate;
        key_poses.band_count = CLQ_KEY_POSE_BAND_MAX;
        for (uint32_t i = 0; i < CLQ_KEY_POSE_BAND_MAX; ++i)
            key_poses.bands[i].distance_min_m = static_cast<float>(10 * i);
        key_poses.max_kept = 0;
        key_poses.budget_bytes = 1;
        EXPECT_EQ(create(key_poses), CLQ_OK) << clq_last_error();
    }
}

TEST_F(KeyPoses, AreSkinnedOnceWhateverTheNumberOfViewsAndNotAgainWhileWanted)
{
    clq_key_poses key_poses = whole_crowd(CLQ_KEY_POSE_INTERMITTENT);
    key_poses.rate_hz = 10;
    ASSERT_EQ(create(key_poses), CLQ_OK) << clq_last_error();
    stand(40, 3);
    const clq_key_pose_stats first = update(1);
    EXPECT_EQ(first.requested, 40u);
    EXPECT_EQ(first.served, 40u);
    EXPECT_EQ(first.updated, first.wanted) << "each once, for 40 individuals in three views";
    EXPECT_LE(first.wanted, 11u) << "the clip lasts one second";
    EXPECT_GE(first.wanted, 5u);
    EXPECT_EQ(first.held, first.wanted);
    EXPECT_GT(first.bytes, 0u);
    const clq_key_pose_stats again = update(1);
    EXPECT_EQ(again.updated, 0u);
    EXPECT_EQ(again.served, 40u);
}

TEST_F(KeyPoses, ThatDoNotFitAreSkinnedForEachActorThatShowsThem)
{
    clq_key_poses key_poses = whole_crowd(CLQ_KEY_POSE_INTERMITTENT);
    key_poses.rate_hz = 10;
    uint64_t hashes[3];
    const uint32_t kept[] = {256, 3, 0};
    for (int i = 0; i < 3; ++i) {
        key_poses.max_kept = kept[i];
        ASSERT_EQ(create(key_poses), CLQ_OK) << clq_last_error();
        stand(40, 1);
        const clq_key_pose_stats stats = update(1);
        EXPECT_EQ(stats.requested, 40u);
        EXPECT_LE(stats.held, kept[i]);
        EXPECT_EQ(stats.served == 40, i == 0) << stats.served;
        EXPECT_EQ(stats.served == 0, i == 2) << stats.served;
        hashes[i] = clq_view_get_hash(views_[0]);
    }
    EXPECT_EQ(hashes[1], hashes[0]);
    EXPECT_EQ(hashes[2], hashes[0]);
}

TEST_F(KeyPoses, NullPointersAreRefused)
{
    ASSERT_EQ(create(clq_key_poses_init()), CLQ_OK);
    clq_key_pose_stats stats = clq_key_pose_stats_init();
    EXPECT_EQ(clq_crowd_get_key_pose_stats(nullptr, &stats), CLQ_ARGUMENT);
    EXPECT_EQ(clq_crowd_get_key_pose_stats(crowd_, nullptr), CLQ_ARGUMENT);
    bool chosen[4] = {true, true, true, true};
    EXPECT_EQ(clq_key_poses_choose(nullptr, 1, 2, chosen, 4), CLQ_ARGUMENT);
    const clq_key_pose_bin bin = {0, 1, 1};
    EXPECT_EQ(clq_key_poses_choose(&bin, 1, 2, nullptr, 4), CLQ_ARGUMENT);
    EXPECT_EQ(clq_key_poses_choose(nullptr, 0, 2, nullptr, 0), CLQ_OK) << "nothing to choose from";
}

TEST_F(KeyPoses, AChoiceAmongMissingKeyPosesIsRefusedAndWritesNothing)
{
    bool chosen[4] = {true, true, true, true};
    const clq_key_pose_bin bins[] = {{0, 1, 5}, {3, 4, 1}};
    EXPECT_EQ(clq_key_poses_choose(bins, 2, 2, chosen, 4), CLQ_ARGUMENT);
    EXPECT_TRUE(mentions("bin 1") && mentions("3 and 4") && mentions("there are 4")) << clq_last_error();
    for (const bool one : chosen) EXPECT_TRUE(one);
    EXPECT_EQ(clq_key_poses_choose(bins, 1, 0, chosen, 4), CLQ_OK);
    for (const bool one : chosen) EXPECT_FALSE(one) << "no room, none chosen";
    EXPECT_EQ(clq_key_poses_choose(bins, 1, 2, chosen, 4), CLQ_OK);
    EXPECT_TRUE(chosen[0] && chosen[1] && !chosen[2] && !chosen[3]);
}
