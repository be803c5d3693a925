// Random idle clips (S0 7.1).
#include <gtest/gtest.h>

#include "lib/crowd/edits.h"
#include "test_actors.h"

namespace claque::behave
{

using namespace testing_support;

TEST(Idle, PlaysRandomClipsFromTheirStart)
{
    TestActors test_actors(2);
    crowd::Idle idle(std::pmr::get_default_resource());
    idle.clips = {0, 2, 1};
    idle.slot_s = 4;
    const uint32_t mechanism = test_actors.add(std::move(idle));
    const auto play = [&](double t, uint32_t row = 0) { return plays_at(test_actors.crowd, row, t, 0).now; };
    int drawn[3] = {0, 0, 0}, changes = 0;
    double last = play(0).start_s;
    for (int i = 0; i < 40000; ++i) {
        const double t = i * 0.1;
        const crowd::Play now = play(t);
        ASSERT_LT(now.clip, 3u);
        ASSERT_GE(t - now.start_s, -1e-9);
        ASSERT_LE(t - now.start_s, 4 + 1e-9);
        ASSERT_EQ(now.speed, 1);
        ASSERT_EQ(now.phase_s, 0);
        if (now.start_s == last) continue;
        EXPECT_NEAR(now.start_s - last, 4, 1e-9);
        last = now.start_s;
        ++changes, ++drawn[now.clip];
    }
    EXPECT_NEAR(changes, 1000, 2);
    for (const int n : drawn) EXPECT_GT(n, 250);
    EXPECT_NE(play(0, 0).start_s, play(0, 1).start_s) << "not all at once";
    const MechanismLevels all_off = mechanism_levels(test_actors.crowd, 0, 0, test_actors.tmpl->levels[0]) | off;
    EXPECT_EQ(plays_at(test_actors.crowd, 0, 3, all_off).now.clip, model::none)
        << "the actor's own clip when the mechanism is disabled";
    crowd::detach_mechanism(test_actors.crowd, test_actors.ids[0], mechanism);
    EXPECT_EQ(play(3).clip, model::none);
}

TEST(Idle, TheHighestEnabledPriorityPlays)
{
    TestActors test_actors;
    crowd::Idle low(std::pmr::get_default_resource()), high(std::pmr::get_default_resource());
    low.clips = {1}, high.clips = {2};
    test_actors.add(std::move(high), 2);
    test_actors.add(std::move(low), 1);
    EXPECT_EQ(plays_at(test_actors.crowd, 0, 1, 0).now.clip, 2u);
    EXPECT_EQ(plays_at(test_actors.crowd, 0, 1, MechanismLevels(off) << 4).now.clip, 1u);
}

}  // namespace claque::behave
