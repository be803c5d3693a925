// Commands of hosts, at their time and before it.
#include "lib/behave/command.h"

#include <cmath>

#include <gtest/gtest.h>

#include "lib/base/error.h"
#include "lib/crowd/edits.h"
#include "test_actors.h"

namespace claque::behave
{

using namespace testing_support;

namespace
{

std::vector<std::vector<float>> film(TestActors &test_actors, double from_s, double to_s)
{
    std::vector<std::vector<float>> out;
    for (double t = from_s; t < to_s; t += 0.01) out.push_back(test_actors.at(t));
    return out;
}

template <class Call>
std::string refusal(const Call &call)
{
    try {
        call();
    } catch (const base::Error &error) {
        EXPECT_EQ(error.status(), CLQ_ARGUMENT);
        return error.what();
    }
    return "";
}

}  // namespace

TEST(Command, LeavesTheTimesBeforeItAsTheyWere)
{
    TestActors test_actors;
    crowd::Gaze wanders = gaze();
    wanders.wander_s = 1;
    const uint32_t g = test_actors.add(wanders), e = test_actors.add(expression()), p = test_actors.add(phrase(2));
    const crowd::Id id = test_actors.ids[0];
    const glm::dvec3 left(4, 1, 3), right(-4, 2, 3);
    const auto before = film(test_actors, -5, 20);
    command_gaze(test_actors.crowd, id, g, &left, 20), command_expression(test_actors.crowd, id, e, 1, 20),
        command_phrase(test_actors.crowd, id, p, 20);
    EXPECT_EQ(film(test_actors, -5, 20), before);
    const auto first = film(test_actors, -5, 20.3);
    EXPECT_NE(film(test_actors, 20.1, 20.2), std::vector<std::vector<float>>(first.begin(), first.begin() + 10));
    // In the middle of the turn and of the phrase.
    command_gaze(test_actors.crowd, id, g, &right, 20.3), command_expression(test_actors.crowd, id, e, 0, 20.3),
        command_phrase(test_actors.crowd, id, p, 20.3);
    EXPECT_EQ(film(test_actors, -5, 20.3), first);
    // Two commands are remembered: the one that the first of three replaced has long ended.
    const auto second = film(test_actors, 21.5, 30);
    command_gaze(test_actors.crowd, id, g, nullptr, 30), command_expression(test_actors.crowd, id, e, model::none, 30),
        command_phrase(test_actors.crowd, id, p, 30);
    EXPECT_EQ(film(test_actors, 21.5, 30), second);
}

TEST(Command, ShowsAPoseUntilRandomChoiceResumes)
{
    TestActors test_actors;
    const uint32_t e = test_actors.add(expression());
    const auto alone = film(test_actors, 100, 150);
    command_expression(test_actors.crowd, test_actors.ids[0], e, 1, 10);
    for (double t = 10.4; t < 40; t += 0.05) EXPECT_EQ(test_actors.at(t, frown), 1.0f);
    command_expression(test_actors.crowd, test_actors.ids[0], e, 0, 40);
    EXPECT_EQ(test_actors.at(40, frown), 1.0f);
    EXPECT_GT(test_actors.at(40.2, frown), 0.4f);
    EXPECT_GT(test_actors.at(40.2, smile), 0.3f);
    EXPECT_NEAR(test_actors.at(40.2, left_lid), 0.15f, 1e-5) << "between both poses";
    EXPECT_NEAR(test_actors.at(40.2, right_lid), 0.2f, 1e-5) << "between one pose and rest";
    EXPECT_EQ(test_actors.at(40.4, smile), 0.8f);
    command_expression(test_actors.crowd, test_actors.ids[0], e, model::none, 50);
    EXPECT_LE(steepest(test_actors, 5, 60), 1.5 * 1.0 / 0.4 * 2) << "two blends at once at most";
    EXPECT_EQ(film(test_actors, 100, 150), alone);
}

TEST(Command, SaysAPhraseOnceEvenDuringARandomOne)
{
    TestActors test_actors;
    const uint32_t p = test_actors.add(phrase(-1));
    EXPECT_EQ(test_actors.at(10.2, open_mouth), 0);
    command_phrase(test_actors.crowd, test_actors.ids[0], p, 10);
    EXPECT_EQ(test_actors.at(10, open_mouth), 0);
    EXPECT_EQ(test_actors.at(10.2, open_mouth), 1);
    EXPECT_EQ(test_actors.at(10.45, open_mouth), 0);
    command_phrase(test_actors.crowd, test_actors.ids[0], p, 10.6);
    EXPECT_EQ(test_actors.at(10.2, open_mouth), 1) << "earlier times keep the first phrase";
    EXPECT_EQ(test_actors.at(10.8, open_mouth), 1);
    EXPECT_EQ(test_actors.at(11.05, open_mouth), 0) << "the first one would have its mouth open";
    EXPECT_EQ(test_actors.at(11.9, open_mouth), 0) << "once";
    EXPECT_LE(steepest(test_actors, 9, 13), 1.5 / 0.06 * 2) << "two blends at once at most";
}

TEST(Command, ForAnEarlierTimeReplacesTheLater)
{
    TestActors test_actors;
    const uint32_t e = test_actors.add(expression());
    command_expression(test_actors.crowd, test_actors.ids[0], e, 0, 10);
    command_expression(test_actors.crowd, test_actors.ids[0], e, 1, 30);
    command_expression(test_actors.crowd, test_actors.ids[0], e, 2, 20);
    EXPECT_EQ(test_actors.at(15, smile), 0.8f);
    EXPECT_EQ(test_actors.at(25, smile), 0.0f);
    EXPECT_EQ(test_actors.at(35, frown), 0.0f);
    const uint32_t p = test_actors.add(phrase(-1));
    for (const double at : {10.0, 30.0, 5.0}) command_phrase(test_actors.crowd, test_actors.ids[0], p, at);
    EXPECT_EQ(test_actors.at(5.2, open_mouth), 1);
    EXPECT_EQ(test_actors.at(10.2, open_mouth), 0);
    EXPECT_EQ(test_actors.at(30.2, open_mouth), 0);
}

TEST(Command, KeepsTheCurrentBlendWhenTheNextOneComes)
{
    TestActors test_actors;
    const uint32_t e = test_actors.add(expression());
    command_expression(test_actors.crowd, test_actors.ids[0], e, 0, 0);
    command_expression(test_actors.crowd, test_actors.ids[0], e, 1, 10);
    command_expression(test_actors.crowd, test_actors.ids[0], e, 2, 10.2);
    EXPECT_NEAR(test_actors.at(10.2, smile), 0.4f, 1e-5);
    EXPECT_NEAR(test_actors.at(10.2, frown), 0.5f, 1e-5);
    EXPECT_NEAR(test_actors.at(10.6, frown), 0, 1e-6);
}

TEST(Command, IsForOneActorAlone)
{
    TestActors test_actors(2);
    const uint32_t e = test_actors.add(expression());
    const std::vector<float> other = test_actors.at(31, 1);
    command_expression(test_actors.crowd, test_actors.ids[0], e, other[frown] == 1 ? 0 : 1, 10);
    EXPECT_EQ(test_actors.at(31, 1), other);
    EXPECT_NE(test_actors.at(31, 0), other);
}

TEST(Command, IsRefusedInOneSentence)
{
    TestActors test_actors(1), no_one(1);
    const uint32_t g = test_actors.add(gaze()), e = test_actors.add(expression()), p = test_actors.add(phrase(-1));
    const crowd::Id id = test_actors.ids[0];
    const glm::dvec3 point(1, 2, 3), nowhere(NAN, 0, 0), far(1e300, 0, 0);
    EXPECT_NE(
        refusal([&] { command_gaze(test_actors.crowd, id, e, &point, 0); }).find("mechanism 2 is not of kind 'gaze'"),
        std::string::npos);
    EXPECT_NE(refusal([&] { command_expression(test_actors.crowd, id, g, 0, 0); }).find("not of kind 'expression'"),
              std::string::npos);
    EXPECT_NE(refusal([&] {
                  command_phrase(test_actors.crowd, id, 9, 0);
              }).find("mechanism 10 does not exist: the crowd has 3"),
              std::string::npos);
    EXPECT_NE(refusal([&] {
                  command_expression(test_actors.crowd, id, e, 3, 0);
              }).find("pose 3 does not exist: the expression has 3"),
              std::string::npos);
    EXPECT_NE(refusal([&] { command_phrase(test_actors.crowd, id, p, NAN); }).find("nan"), std::string::npos);
    EXPECT_NE(refusal([&] { command_gaze(test_actors.crowd, id, g, &nowhere, 0); }).find("nan"), std::string::npos);
    EXPECT_NE(refusal([&] { command_gaze(test_actors.crowd, id, g, &far, 0); }).find("1e+300"), std::string::npos);
    crowd::detach_mechanism(test_actors.crowd, id, p);
    EXPECT_NE(refusal([&] { command_phrase(test_actors.crowd, id, p, 0); }).find("mechanism 3 is not attached"),
              std::string::npos);
}

}  // namespace claque::behave
