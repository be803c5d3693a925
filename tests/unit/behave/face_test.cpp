// Expressions, lids and mouths (S0 7.1).
#include <cmath>
#include <set>

#include <gtest/gtest.h>

#include "test_actors.h"

namespace claque::behave
{

using namespace testing_support;

namespace
{

// 0 smile, 1 frown, 2 at rest; model::none in between.
uint32_t shape_shown(const std::vector<float> &dofs)
{
    if (dofs[smile] == 0.8f) return 0;
    if (dofs[frown] == 1.0f) return 1;
    return dofs[smile] == 0 && dofs[frown] == 0 ? 2 : model::none;
}

}  // namespace

TEST(Expression, ShowsEveryPoseAtRandomAndNeverTheSameTwiceRunning)
{
    TestActors test_actors;
    test_actors.add(expression());
    std::vector<uint32_t> shown;
    std::vector<double> since;
    for (double t = -2000; t < 2000; t += 0.05) {
        const uint32_t shape = shape_shown(test_actors.at(t));
        if (shape == model::none || (!shown.empty() && shown.back() == shape)) continue;
        shown.push_back(shape), since.push_back(t);
    }
    EXPECT_NEAR(double(shown.size()), 1000, 20) << "one in 4 s";
    int count[3] = {0, 0, 0};
    for (const uint32_t shape : shown) ++count[shape];
    for (const int c : count) EXPECT_GT(c, 250);
    double least = 99, most = 0;
    for (size_t i = 1; i < since.size(); ++i) {
        least = std::min(least, since[i] - since[i - 1]);
        most = std::max(most, since[i] - since[i - 1]);
    }
    EXPECT_GE(least, 2 - 0.1);
    EXPECT_LE(most, 6 + 0.1);
    EXPECT_GT(most - least, 2) << "not in step with a clock";
}

TEST(Expression, BlendsSmoothly)
{
    TestActors test_actors;
    test_actors.add(expression());
    const float steep = steepest(test_actors, 0, 60);
    EXPECT_LE(steep, 1.5 * 1.0 / 0.4 * 1.01) << "the whole range of a pose in blend_s";
    EXPECT_GT(steep, 1.0);
}

TEST(Expression, OfTwoPosesAlternatesAndOfOneStays)
{
    TestActors two, one;
    crowd::Expression pair = expression(), single = expression();
    pair.poses.pop_back();
    single.poses = {{0, 3}};
    two.add(std::move(pair));
    one.add(std::move(single));
    uint32_t last = model::none;
    int changes = 0;
    for (double t = 0; t < 400; t += 0.05) {
        EXPECT_EQ(shape_shown(one.at(t)), 0u);
        const uint32_t shape = shape_shown(two.at(t));
        ASSERT_NE(shape, 2u);
        if (shape == model::none) continue;
        changes += shape != last;
        last = shape;
    }
    EXPECT_NEAR(changes, 100, 3);
}

TEST(Expression, ChangesAtOnceFarAway)
{
    TestActors test_actors;
    crowd::Mechanism mechanism;
    mechanism.kind = expression();
    mechanism.level_m[0] = 10;
    test_actors.add(std::move(mechanism));
    std::set<float> near, far;
    for (double t = 0; t < 100; t += 0.01)
        near.insert(test_actors.at(t)[smile]), far.insert(test_actors.at(t, 0, 12)[smile]);
    EXPECT_GT(near.size(), 50u);
    EXPECT_EQ(far, (std::set<float>{0, 0.8f}));
}

TEST(Blink, ShutsBothLidsTogetherAsOftenAsItSays)
{
    TestActors test_actors;
    test_actors.add(blink());
    int blinks = 0;
    bool shut = false;
    double last = 0, least = 99, most = 0;
    for (int i = 0; i < 500000; ++i) {
        const std::vector<float> &dofs = test_actors.at(i * 0.002);
        ASSERT_EQ(dofs[left_lid], dofs[right_lid]);
        const bool now = dofs[left_lid] > 1.0f;
        if (now && !shut) {
            if (blinks++) least = std::min(least, i * 0.002 - last), most = std::max(most, i * 0.002 - last);
            last = i * 0.002;
        }
        shut = now;
    }
    EXPECT_LT(least, 2);
    EXPECT_GT(most, 6);
    EXPECT_NEAR(blinks, 250, 25) << "in 1000 s";
    EXPECT_LT(steepest(test_actors, 0, 20), 1.0f / (0.35f * 0.15f) * 1.5f);
}

TEST(Blink, BeginsAndEndsWhereTheLidsAre)
{
    TestActors test_actors;
    test_actors.add(expression(), 0);
    test_actors.add(blink(), 1);
    // With a smile the lids are at 0.3 between two blinks, not at their rest value of 0.1.
    int narrow = 0;
    for (double t = 0; t < 100; t += 0.01) narrow += test_actors.at(t)[right_lid] == 0.3f;
    EXPECT_GT(narrow, 1000);
    EXPECT_LT(steepest(test_actors, 0, 100), 1.1f / (0.35f * 0.15f) * 1.6f);
}

TEST(Phrase, ShowsItsPosesInTime)
{
    TestActors test_actors;
    test_actors.add(phrase(0));
    // Loops of length and blend, without a pause.
    const double round = 1.2f + 0.06f;
    for (int i = -3; i < 3; ++i) {
        const double begin = i * round;
        EXPECT_EQ(test_actors.at(begin + 0.2, open_mouth), 1.0f) << i;
        EXPECT_EQ(test_actors.at(begin + 0.45, open_mouth), 0.0f);
        EXPECT_NEAR(test_actors.at(begin + 0.5299, open_mouth), 0.4f, 0.01f) << "a pose of 30 ms is reached too";
        EXPECT_EQ(test_actors.at(begin + 0.8, open_mouth), 1.0f);
        EXPECT_FLOAT_EQ(test_actors.at(begin + 1.1, open_mouth), 0.4f);
        EXPECT_FLOAT_EQ(test_actors.at(begin + 1.1, smile), 0.2f);
        EXPECT_NEAR(test_actors.at(begin + 1.2599, open_mouth), 0.0f, 0.01f);
    }
    EXPECT_LE(steepest(test_actors, -3, 3), 1.5 * 0.6 / 0.03 * 1.01) << "the shortest blend is one of 30 ms";
}

TEST(Phrase, PausesForAboutAsLongAsItSays)
{
    TestActors test_actors;
    test_actors.add(phrase(3));
    double last = -1, least = 99, most = 0;
    int said = 0;
    bool speaks = false;
    for (int i = 0; i < 100000; ++i) {
        const double t = i * 0.01;
        const bool now = test_actors.at(t, open_mouth) > 0;
        if (now && !speaks && t - last > 0.5) {
            if (said > 0) least = std::min(least, t - last), most = std::max(most, t - last);
            ++said;
        }
        if (now) last = t;
        speaks = now;
    }
    EXPECT_NEAR(said, 1000 / 4.26, 3);
    EXPECT_GE(least, 1.5 - 0.05);
    EXPECT_LE(most, 4.5 + 0.05);
    EXPECT_GT(most - least, 1.5);
}

TEST(Phrase, AKeyAtTheVeryEndIsTheRest)
{
    TestActors test_actors;
    crowd::Phrase twice = phrase(0);
    twice.keys = {{0.0f, 0}, {1.2f, model::none}};
    test_actors.add(std::move(twice));
    EXPECT_EQ(test_actors.at(1.19, open_mouth), 1.0f);
    EXPECT_LT(test_actors.at(1.23, open_mouth), 0.6f);
    EXPECT_GT(test_actors.at(1.23, open_mouth), 0.4f);
}

}  // namespace claque::behave
