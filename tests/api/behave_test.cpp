// Control mechanisms and root paths through the C API: what is accepted moves the actor.
#include <cmath>

#include "tests/api/behave_api.h"

TEST_F(BehaveApi, TakesOneOfEachKindAndMovesTheActor)
{
    const uint64_t still = hash(1.5);
    for (const clq_mechanism_kind kind : {CLQ_MECHANISM_EXPRESSION, CLQ_MECHANISM_BLINK, CLQ_MECHANISM_PHRASE,
                                          CLQ_MECHANISM_IDLE, CLQ_MECHANISM_HOST}) {
        clq_mechanism_def wanted = def(kind);
        wanted.blink.period_s = 1.01f, wanted.blink.close_s = 1;
        const clq_mechanism mechanism = add(wanted);
        ASSERT_EQ(attach_mechanism(mechanism), CLQ_OK) << clq_last_error();
        EXPECT_NE(hash(1.5), still) << kind;
        ASSERT_EQ(clq_actor_detach_mechanism(crowd_, actor_, mechanism), CLQ_OK);
        EXPECT_EQ(hash(1.5), still) << kind;
    }
    const clq_mechanism gaze = add(def(CLQ_MECHANISM_GAZE));
    ASSERT_EQ(attach_mechanism(gaze), CLQ_OK);
    const double point[3] = {5, 0, -7};
    ASSERT_EQ(clq_actor_gaze(crowd_, actor_, gaze, point, 0), CLQ_OK) << clq_last_error();
    EXPECT_NE(hash(1.5), still);
    ASSERT_EQ(clq_actor_gaze(crowd_, actor_, gaze, nullptr, 1), CLQ_OK);
    EXPECT_EQ(hash(1.5), still) << "straight on again";
}

TEST_F(BehaveApi, RunsTheHostsMechanismForVisibleActors)
{
    ASSERT_EQ(attach_mechanism(add(def(CLQ_MECHANISM_HOST))), CLQ_OK);
    const uint64_t left = hash(1);
    ASSERT_EQ(calls_.size(), 1u);
    EXPECT_EQ(calls_[0].actor.index1, actor_.index1);
    EXPECT_LE(calls_[0].time_s, 1.0);
    EXPECT_GT(calls_[0].time_s, 0.7) << "its tick";
    EXPECT_NEAR(calls_[0].eye_distance_m, 10, 1.1);
    EXPECT_EQ(calls_[0].visible, 1);
    wanted_ = NAN;
    EXPECT_NE(hash(2), left) << "NaN is ignored";
    wanted_ = 0.7f;
    EXPECT_EQ(hash(3), left);
    const clq_transform away = {{0, 0, 50}, {0, 0, 0, 1}, 1};
    ASSERT_EQ(clq_crowd_set_transforms(crowd_, &actor_, &away, 1), CLQ_OK);
    const size_t before = calls_.size();
    hash(4);
    EXPECT_EQ(calls_.size(), before);
}

TEST_F(BehaveApi, RunsMechanismsWithMemoryInEveryUpdateAlsoForInvisibleActors)
{
    clq_mechanism_def wanted = def(CLQ_MECHANISM_HOST);
    wanted.host.has_memory = 1;
    ASSERT_EQ(attach_mechanism(add(wanted)), CLQ_OK);
    const uint64_t still = hash(1);
    wanted_ = -0.7f;
    EXPECT_NE(hash(1.001), still) << "due in every frame";
    const clq_transform away = {{0, 0, 50}, {0, 0, 0, 1}, 1};
    ASSERT_EQ(clq_crowd_set_transforms(crowd_, &actor_, &away, 1), CLQ_OK);
    hash(1.002);
    ASSERT_EQ(calls_.size(), 3u);
    EXPECT_EQ(calls_[1].time_s, 1.001);
    EXPECT_EQ(calls_[2].time_s, 1.002);
    EXPECT_EQ(calls_[2].visible, 0);
}

TEST_F(BehaveApi, CarriesTheSkeletonRootAlongAPath)
{
    const uint64_t still = hash(1);
    clq_root_path_def way = clq_root_path_def_init();
    way.count = 3, way.positions = positions_, way.duration_s = 4;
    clq_root_path flight, table;
    ASSERT_EQ(clq_crowd_add_root_path(crowd_, &way, &flight), CLQ_OK) << clq_last_error();
    way.rotations_xyzw = rotations_, way.times_s = times_;
    ASSERT_EQ(clq_crowd_add_root_path(crowd_, &way, &table), CLQ_OK) << clq_last_error();
    clq_root_path_play motion = {flight, 1, 0, 0};
    ASSERT_EQ(clq_actor_play_root_path(crowd_, actor_, &motion), CLQ_OK) << clq_last_error();
    const uint64_t flown = hash(1);
    EXPECT_NE(flown, still);
    motion.path = table;
    ASSERT_EQ(clq_actor_play_root_path(crowd_, actor_, &motion), CLQ_OK);
    EXPECT_NE(hash(1), flown);
    motion.path = {0};
    ASSERT_EQ(clq_actor_play_root_path(crowd_, actor_, &motion), CLQ_OK);
    EXPECT_EQ(hash(1), still);
}

TEST_F(BehaveApi, LetsActorsFollowTheGround)
{
    const uint64_t still = hash(1);
    ASSERT_EQ(clq_crowd_set_ground(
                  crowd_, [](void *, const double point[3]) { return 0.5 + 0 * point[0]; }, nullptr),
              CLQ_OK);
    EXPECT_EQ(hash(1), still);
    ASSERT_EQ(clq_actor_follow_ground(crowd_, actor_, 1, 1), CLQ_OK);
    EXPECT_NE(hash(1), still);
    ASSERT_EQ(clq_crowd_set_ground(crowd_, nullptr, nullptr), CLQ_OK);
    EXPECT_EQ(hash(1), still);
    EXPECT_EQ(clq_actor_follow_ground(crowd_, actor_, -1, 0), CLQ_ARGUMENT);
    EXPECT_NE(std::string(clq_last_error()).find("-1"), std::string::npos);
    EXPECT_EQ(clq_actor_follow_ground(crowd_, {9, 9}, 1, 0), CLQ_STALE_ID);
}

TEST_F(BehaveApi, AttachesUpToSixteenToAnActor)
{
    std::vector<clq_mechanism> all;
    for (int i = 0; i < 17; ++i) all.push_back(add(def(CLQ_MECHANISM_BLINK)));
    for (int i = 0; i < 16; ++i) ASSERT_EQ(attach_mechanism(all[i]), CLQ_OK) << i;
    EXPECT_EQ(attach_mechanism(all[16]), CLQ_LIMIT);
    EXPECT_EQ(attach_mechanism(all[3], 5), CLQ_OK) << "it is attached already";
    hash(1);
}
