// Which exit people take: test 11 of RiMEA's guideline (version 3.0.0), with a fifth of its thousand people.
#include <filesystem>
#include <fstream>

#include "tests/staged/staged_world.h"

namespace staged_test
{
namespace
{

using namespace scenes;

constexpr uint32_t people = 200;

// People in the western half of a room of 30 x 20 m with two exits of 1 m in its south wall.
Scenario room(const char *widths, const char *exit = "[3.5, 0.0, 5.0]", const char *door = "[3.0, 0.0, 4.0, 0.5]")
{
    const std::string folder = testing::TempDir() + "claque_exits";
    std::filesystem::create_directories(folder);
    std::ofstream machine(folder + "/leaver.toml"), hall(folder + "/room.wkt"), scenario(folder + "/room.toml");
    machine
        << "machine = 'leaver'\n[events]\nexit = 1\n[states.waits]\ninitial = true\n"
           "transitions = [ { after = 0.2, to = 'goes' } ]\n[states.goes]\nenter = [ { call = 'exit' } ]\n"
           "while = { every = [2, 4], do = [ { call = 'exit' } ] }\n"
           "transitions = [ { on = 'exit', do = [ { go = 'sender', near = 0.8 } ] }, { on = 'arrived', to = 'out' } ]"
           "\n[states.out]\nenter = [ { call = 'leave' } ]\n";
    hall << "POLYGON ((0 0, 0 20, 30 20, 30 0, 27 0, 27 -6, 26 -6, 26 0, 4 0, 4 -6, 3 -6, 3 0, 0 0))\n";
    scenario << "name = 'room'\n[stage]\nseconds = 200.0\n[[characters]]\nname = 'people'\ncharacter = 'citizen'\n"
                "[places]\nwest = "
             << exit
             << "\neast = [26.5, 0.0, 5.0]\n[navigation]\narea = 'room.wkt'\n"
                "[[doors]]\nname = 'west'\narea = "
             << door
             << "\n[[doors]]\nname = 'east'\n"
                "area = [26.0, 0.0, 27.0, 0.5]\n[[agents]]\nclass = 'people'\nmachine = 'leaver.toml'\ncount = "
             << people << "\narea = [0.5, -19.5, 14.5, -0.5]\nexits = ['west', 'east']\n"
             << widths;
    machine.close(), hall.close(), scenario.close();
    return load_scenario(folder + "/room.toml");
}

struct Left {
    size_t west, east;
    double last_s = 0;
};
Left left(const Scenario &scenario)
{
    World world(scenario, 1, false);
    while (world.run().counts().left < people && world.run().decided_s() < 200) world.run().tick();
    EXPECT_EQ(world.run().counts().left, people);
    const auto doors = world.run().doors();
    return {doors[0].passed_s.size(), doors[1].passed_s.size(), world.run().decided_s()};
}

TEST(Exits, NearestIsPreferredAndAnotherTakenWhereItIsQuicker)
{
    const Left by_way = left(room("")), by_time = left(room("exit_widths_m = [1.0, 1.0]\n"));
    std::printf("exits: %zu and %zu people in %.0f s; by the way alone %zu and %zu in %.0f s\n", by_time.west,
                by_time.east, by_time.last_s, by_way.west, by_way.east, by_way.last_s);
    EXPECT_EQ(by_way.east, 0u);
    EXPECT_GT(by_time.west, by_time.east + people / 20);
    EXPECT_GT(by_time.east, people / 5);
    EXPECT_LT(by_time.last_s, 0.75 * by_way.last_s);
}

TEST(Exits, WiderOneIsTakenByMore)
{
    const Left equal = left(room("exit_widths_m = [1.0, 1.0]\n")), wider = left(room("exit_widths_m = [1.0, 4.0]\n"));
    EXPECT_GT(wider.east, equal.east + people / 20);
}

// A saved run keeps the choices.
TEST(Exits, AreChosenAlikeInARunThatIsRestored)
{
    const Scenario scenario = room("exit_widths_m = [1.0, 1.0]\n");
    World world(scenario, 1, false), again(scenario, 1, false);
    world.run().decide(15);
    again.run().restore(world.run().save());
    for (World *one : {&world, &again}) one->run().decide(40);
    EXPECT_GT(world.run().counts().left, 20u);
    EXPECT_EQ(world.run().info().hash, again.run().info().hash);
    EXPECT_EQ(world.run().doors()[1].passed_s, again.run().doors()[1].passed_s);
}

std::string refusal_of(const Scenario &scenario)
{
    try {
        World world(scenario, 1, false);
    } catch (const Failure &failure) {
        return failure.what();
    }
    return "nothing is refused";
}

TEST(Exits, AndDoorsOffTheGroundAreNamedBeforeTheRunBegins)
{
    const std::string exit = refusal_of(room("", "[3.5, 0.0, 50.0]"));
    EXPECT_NE(exit.find("room.toml:18:1"), std::string::npos) << exit;
    EXPECT_NE(exit.find("no ground is within 2 m of the exit 'west'"), std::string::npos) << exit;
    const std::string door = refusal_of(room("", "[3.5, 0.0, 5.0]", "[10.0, 1.0, 11.0, 2.0]"));
    EXPECT_NE(door.find("room.toml:12:1"), std::string::npos) << door;
    EXPECT_NE(door.find("lies on no ground: walkable ground begins radius_m away from walls"), std::string::npos)
        << door;
}

}  // namespace
}  // namespace staged_test
