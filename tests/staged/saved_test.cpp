// A run that is restored has the future of the one that was saved.
#include "samples/stage/door_leaves.h"
#include "tests/staged/staged_world.h"

namespace staged_test
{
namespace
{

using namespace scenes;

// With people that come while it runs, and a door that closes.
Scenario coming_and_going()
{
    Scenario scenario = evacuation(12, 30);
    scenario.stage->agents[1].per_minute = 60;
    return scenario;
}

TEST(SavedRun, HasTheSameFuture)
{
    std::vector<uint8_t> bytes;
    std::vector<uint64_t> lists;
    uint64_t hash = 0;
    {
        World world(coming_and_going(), 2, true);
        for (int second = 0; second <= 22; ++second) world.show(second);
        bytes = world.scene->save();
        for (int second = 22; second <= 45; ++second) lists.push_back(world.show(second));
        world.scene->rest();
        hash = world.run().info().hash;
        EXPECT_EQ(world.run().counts().came, 42u);
        EXPECT_GT(world.run().counts().left, 20u);
    }
    for (const bool apart : {true, false}) {
        World again(coming_and_going(), 1, apart);
        again.show(3);  // whatever it did before
        again.scene->restore(bytes);
        EXPECT_EQ(again.run().shown_s(), 22);
        std::vector<uint64_t> now;
        for (int second = 22; second <= 45; ++second) now.push_back(again.show(second));
        again.scene->rest();
        EXPECT_EQ(now, lists);
        EXPECT_EQ(again.run().info().hash, hash);
        EXPECT_EQ(again.run().counts().came, 42u);
        EXPECT_EQ(staged::is_open(again.scene->crowd(), 2), false);
    }
}

TEST(SavedRun, IsTheSameBytesAgain)
{
    World world(coming_and_going(), 1, true);
    for (const double time_s : {5.0, 26.0}) {  // before and after a door closes
        world.show(time_s);
        const std::vector<uint8_t> bytes = world.scene->save();
        World again(coming_and_going(), 2, false);
        again.scene->restore(bytes);
        EXPECT_TRUE(again.scene->save() == bytes) << time_s << " s";
    }
}

std::string refusal(World &world, const std::vector<uint8_t> &bytes)
{
    try {
        world.scene->restore(bytes);
    } catch (const Failure &failure) {
        return failure.what();
    }
    return "taken";
}

TEST(SavedRun, OfAnotherScenarioOrDamagedIsRefused)
{
    World world(coming_and_going(), 1, false), other(evacuation(3, 1), 1, false);
    world.show(5);
    const std::vector<uint8_t> bytes = world.scene->save();
    EXPECT_NE(refusal(other, bytes), "taken");
    EXPECT_NE(refusal(world, {}).find("this is no saved run"), std::string::npos);
    for (size_t size = 0; size < 3000; size += 7)
        EXPECT_NE(refusal(world, {bytes.begin(), bytes.begin() + long(size)}), "taken") << size;
    std::vector<uint8_t> longer = bytes;
    longer.push_back(0);
    EXPECT_NE(refusal(world, longer), "taken");
    EXPECT_EQ(refusal(world, bytes), "taken");
}

}  // namespace
}  // namespace staged_test
