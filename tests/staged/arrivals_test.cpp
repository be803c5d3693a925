// People come when the scenario says, where there is room.
#include "tests/staged/staged_world.h"

namespace staged_test
{
namespace
{

using namespace scenes;

TEST(ArrivalsOfARun, ComeOneAfterTheOtherAtTheirRate)
{
    Scenario scenario = evacuation(1, 60);
    scenario.stage->agents[1].from_s = 2;
    scenario.stage->agents[1].per_minute = 120;
    const std::vector<staged::Arrival> all = staged::arrivals_of(*scenario.stage, 1);
    ASSERT_EQ(all.size(), 61u);
    EXPECT_EQ(all[0].due_s, staged::begin_s) << "is there from the beginning";
    EXPECT_EQ(all[1].due_s, 2);
    EXPECT_NEAR(all.back().due_s, 2 + 59 * 0.5, 5);
    for (size_t i = 2; i < all.size(); ++i) {
        EXPECT_GE(all[i].due_s - all[i - 1].due_s, 0.25);
        EXPECT_LE(all[i].due_s - all[i - 1].due_s, 0.75);
    }
    World world(scenario, 1, false);
    world.run().decide(1.9);
    EXPECT_EQ(world.run().counts().came, 1u);
    world.run().decide(10);
    EXPECT_NEAR(double(world.run().counts().came), 17, 4);
}

TEST(ArrivalsOfARun, WaitUntilThereIsRoom)
{
    Scenario scenario = evacuation(1, 40);
    ScenarioAgents &workers = scenario.stage->agents[1];
    scenario.stage->places.push_back({"gate", {-18, 0, 8}});
    workers.outline.clear(), workers.from = {scenario.stage->places.size() - 1};
    workers.within_m = 0.4, workers.apart_m = 0.7, workers.per_minute = 600;
    World world(scenario, 1, false);
    world.run().decide(10);
    EXPECT_LE(world.run().counts().came, 3u) << "those who came stand there";
    EXPECT_GE(world.run().counts().came, 2u);
    world.run().decide(60);
    const uint64_t before = world.run().counts().left;
    EXPECT_GE(before, 3u) << "they went when the alarm came";
    EXPECT_GE(world.run().counts().came, before + 2) << "and made room for others, who did not hear it";
}

TEST(ArrivalsOfARun, TooManyInOnePlaceAreRefused)
{
    Scenario scenario = evacuation(1, 2000);
    World world(scenario, 1, false);
    try {
        world.run().decide(0);
        FAIL() << "2000 found room";
    } catch (const Failure &failure) {
        EXPECT_NE(std::string(failure.what()).find("there is no room for 2000 people"), std::string::npos)
            << failure.what();
    }
}

TEST(ArrivalsOfARun, OffTheGroundAreRefusedBeforeTheRunBegins)
{
    for (const double per_minute : {0.0, 60.0}) {
        Scenario scenario = evacuation(1, 20);
        ScenarioAgents &workers = scenario.stage->agents[1];
        for (size_t i = 0; i < workers.outline.size(); i += 2) workers.outline[i] += 500;
        workers.per_minute = per_minute;
        try {
            World world(scenario, 1, false);
            FAIL() << per_minute << " people a minute appear on no ground";
        } catch (const Failure &failure) {
            EXPECT_EQ(std::string(failure.what()),
                      workers.at + ": there is no ground where these agents appear (x is east, z is south)");
        }
    }
}

}  // namespace
}  // namespace staged_test
