// With the live clock a budget of poses is kept, while no actor waits longer than twice its period. Loads are
// simulated: the test's own clock times the updates.
#include <cmath>

#include <gtest/gtest.h>

#include "lib/crowd/edits.h"
#include "support/scene.h"

namespace claque
{

using namespace testing_support;

namespace
{

// The longest time that any actor keeps a pose, in its periods, and the counters, over some seconds.
struct Waits {
    double periods = 0;
    uint32_t most_evaluated = 0, deferred = 0, overdue = 0, over_budget = 0;
};

Waits simulate(Scene &scene, double seconds, double frame_s)
{
    Waits waits;
    std::vector<double> shown(scene.crowd.row_count()), renewed(shown.size());
    for (int f = 0; f * frame_s < seconds; ++f) {
        const double t = 10 + f * frame_s;
        EXPECT_TRUE(scene.try_update(t).ok());
        const frame::Stats &stats = scene.frame.stats();
        EXPECT_EQ(stats.due, stats.animated + stats.deferred);
        EXPECT_GT(stats.visible, scene.crowd.row_count() / 2);
        if (f == 0) {  // every actor is new
            for (uint32_t i = 0; i < shown.size(); ++i)
                shown[i] = scene.frame.visibility(scene.crowd, i).shown_s, renewed[i] = t;
            continue;
        }
        waits.most_evaluated = std::max(waits.most_evaluated, stats.animated);
        waits.deferred += stats.deferred;
        waits.overdue += stats.overdue;
        waits.over_budget += stats.over_budget;
        for (uint32_t i = 0; i < scene.crowd.row_count(); ++i) {
            const frame::ActorVisibility seen = scene.frame.visibility(scene.crowd, i);
            if (!seen.visible) continue;
            if (seen.shown_s != shown[i]) shown[i] = seen.shown_s, renewed[i] = t;
            const double period = std::max(double(seen.period_s), frame_s);
            waits.periods = std::max(waits.periods, (t - renewed[i]) / period);
        }
    }
    return waits;
}

// The mean number of poses evaluated per update without a budget.
double load(uint32_t count, double frame_s)
{
    Scene scene(people(count, frame::Clock::live));
    uint64_t sum = 0;
    for (int f = 0; f < 200; ++f) {
        EXPECT_TRUE(scene.try_update(10 + f * frame_s).ok());
        if (f > 0) sum += scene.frame.stats().animated;
    }
    return double(sum) / 199;
}

}  // namespace

TEST(BudgetLaw, WithinTheBudgetNoActorWaitsLongerThanTwiceItsPeriod)
{
    const double frame_s = 1 / 60.0;
    const double mean = load(300, frame_s);
    for (const double share : {1.1, 0.9, 0.75, 0.65}) {
        Scene scene(people(300, frame::Clock::live, static_cast<uint32_t>(mean * share)));
        const Waits waits = simulate(scene, 10, frame_s);
        std::printf("budget %.2f of the load of %.1f: longest wait %.3f periods\n", share, mean, waits.periods);
        EXPECT_LE(waits.most_evaluated, static_cast<uint32_t>(mean * share));
        EXPECT_GT(waits.deferred, 0u);
        EXPECT_EQ(waits.overdue, 0u);
        EXPECT_LE(waits.periods, 2 + 1e-6);
    }
}

TEST(BudgetLaw, ABudgetThatIsTooSmallIsKeptAndSaysSo)
{
    const double frame_s = 1 / 60.0;
    const uint32_t budget = static_cast<uint32_t>(load(300, frame_s) * 0.2);
    Scene scene(people(300, frame::Clock::live, budget));
    const Waits waits = simulate(scene, 10, frame_s);
    EXPECT_EQ(waits.most_evaluated, budget);
    EXPECT_GT(waits.overdue, 1000u);
    EXPECT_EQ(waits.over_budget, 0u);
    EXPECT_LT(waits.periods, 12);  // waiting times are alike
}

TEST(BudgetLaw, AnActorWithoutAPoseGetsOneWhateverTheBudget)
{
    Scene scene(people(100, frame::Clock::live, 5));
    scene.update(3);
    const frame::Stats &stats = scene.frame.stats();
    EXPECT_EQ(stats.animated, stats.visible);
    EXPECT_EQ(stats.over_budget, stats.visible - 5);
    EXPECT_EQ(stats.deferred, 0u);
    crowd::Play play;
    play.clip = clip_sway;
    for (uint32_t i = 0; i < 40; ++i) crowd::play(scene.crowd, scene.ids[i], play);
    scene.update(3.001);
    EXPECT_GT(scene.frame.stats().over_budget, 20u);
    EXPECT_LE(scene.frame.stats().animated, 40u);
}

// Room for all palettes, for some, and for a few.
TEST(BudgetLaw, PosesThatNoCacheKeepsAreEvaluatedFirst)
{
    constexpr uint32_t budget = 45;
    SceneDef def = people(100, frame::Clock::live, budget);
    uint32_t within = 0, beyond = 0;
    for (const uint64_t bytes : {200000, 50000, 10000}) {
        def.settings.caches.budget_bytes = bytes;
        Scene scene(def);
        scene.update(3);
        for (int f = 1; f < 60; ++f) {
            scene.update(3 + f * 0.1);
            const frame::Stats &stats = scene.frame.stats();
            EXPECT_EQ(stats.over_budget, stats.animated > budget ? stats.animated - budget : 0) << bytes;
            EXPECT_EQ(stats.due, stats.animated + stats.deferred) << bytes;
            EXPECT_TRUE(stats.animated == budget || stats.over_budget > 0) << bytes;
            (stats.over_budget > 0 ? beyond : within) += stats.deferred;
        }
    }
    EXPECT_GT(within, 300u);
    EXPECT_GT(beyond, 300u);
}

TEST(BudgetLaw, NearActorsGoFirstAndWaitingActorsShowTheirLastTick)
{
    constexpr uint32_t count = 200, budget = 10;
    const auto stand_in_a_row = [](Scene &scene) {
        crowd::Play play;
        play.clip = clip_walk;
        for (uint32_t i = 0; i < count; ++i) {
            crowd::Transform place;
            place.position = glm::dvec3(0, 1, -60 - 0.3 * i);  // all at 4 Hz
            crowd::set_transforms(scene.crowd, &scene.ids[i], &place, 1);
            crowd::play(scene.crowd, scene.ids[i], play);
        }
        scene.update(3);
    };
    Scene scene(people(count, frame::Clock::live, budget)), free(people(count, frame::Clock::live));
    stand_in_a_row(scene), stand_in_a_row(free);
    std::vector<double> first;
    for (uint32_t i = 0; i < count; ++i) first.push_back(scene.frame.visibility(scene.crowd, i).shown_s);
    scene.update(3.05), free.update(3.05);  // about one in five is due, and no actor is urgent
    ASSERT_GT(scene.frame.stats().deferred, 10u);
    uint32_t renewed = 0;
    for (uint32_t i = 0; i < count; ++i) {
        const double expected = renewed < budget ? free.frame.visibility(free.crowd, i).shown_s : first[i];
        EXPECT_EQ(scene.frame.visibility(scene.crowd, i).shown_s, expected) << i;
        renewed += expected != first[i];
    }
    EXPECT_EQ(renewed, budget);
}

TEST(BudgetLaw, AnyNumberOfThreadsDefersTheSameActors)
{
    const auto walk = [](const base::Jobs &jobs) {
        Scene scene(people(300, frame::Clock::live, 20));
        std::vector<uint64_t> out;
        for (int f = 0; f < 60; ++f) {
            scene.look(0, glm::dvec3(0, 1.7, f * 0.2), glm::dvec3(f % 7 - 3, 1, -30));
            out.push_back(scene.update(5 + f / 60.0, jobs));
        }
        return out;
    };
    const std::vector<uint64_t> one = walk(base::Jobs());
    for (const uint32_t count : {2u, 5u}) {
        Threads threads(count);
        EXPECT_EQ(walk(threads.jobs()), one) << count;
    }
}

TEST(BudgetLaw, ABudgetInMillisecondsBecomesOneOfPosesByWhatTheyCost)
{
    // A clock on which everything takes 1 ms: an update reads it four times, so that posing and skinning take 2 ms.
    double now = 0;
    SceneDef def = people(300, frame::Clock::live);
    def.settings.caches.can_defer = true;
    def.settings.update_budget_ms = 1;
    def.settings.now = {[](void *user) { return *static_cast<double *>(user) += 1e-3; }, &now, {}};
    Scene scene(def);
    scene.update(3);  // all 300, in 2 ms: a pose costs 2/300 ms, so a budget of 1 ms allows half of them
    const uint32_t all = scene.frame.stats().animated;
    scene.update(3.5);
    EXPECT_EQ(scene.frame.stats().animated, all / 2);
}

}  // namespace claque
