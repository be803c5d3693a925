// People of a run whose machines name no speed walk at speeds of their own.
#include <cmath>
#include <filesystem>
#include <fstream>

#include "tests/staged/staged_world.h"

namespace staged_test
{
namespace
{

using namespace scenes;

constexpr uint64_t seeds = 12;

// One person goes from one end of a corridor of 60 m to the other.
Scenario corridor(const char *speed)
{
    const std::string folder = testing::TempDir() + "claque_own_speeds" + std::to_string(std::string(speed).size());
    std::filesystem::create_directories(folder);
    std::ofstream machine(folder + "/walker.toml"), hall(folder + "/hall.wkt"), scenario(folder + "/corridor.toml");
    machine << "machine = 'walker'\n[variables]\nown = 0.0\n[states.a]\ninitial = true\n"
               "transitions = [ { after = 0.2, to = 'b' } ]\n[states.b]\nenter = [ { set = 'own', to = 'own_speed' }, "
               "{ go = 'other side'"
            << speed << " } ]\n[places]\n'other side' = [0.0, 0.0, 58.0]\n";
    hall << "POLYGON ((-1 1, 1 1, 1 -60, -1 -60, -1 1))\n";
    scenario << "name = 'corridor'\n[stage]\nseconds = 20.0\n[[characters]]\nname = 'people'\ncharacter = 'citizen'\n"
                "[places]\n'start' = [0.0, 0.0, 0.0]\n[navigation]\narea = 'hall.wkt'\n[[agents]]\nclass = 'people'\n"
                "machine = 'walker.toml'\nfrom = ['start']\nwithin_m = 0.0\n";
    machine.close(), hall.close(), scenario.close();
    return load_scenario(folder + "/corridor.toml");
}

// A person climbs or descends a slope of 0.5 that is 10 m long over the ground.
Scenario slope(bool up, const std::string &share)
{
    const std::string folder = testing::TempDir() + "claque_slope";
    std::filesystem::create_directories(folder);
    std::ofstream machine(folder + "/walker.toml"), ground(folder + "/slope.nav"), scenario(folder + "/slope.toml");
    machine << "machine = 'walker'\n[states.a]\ninitial = true\ntransitions = [ { after = 0.2, to = 'b' } ]\n"
               "[states.b]\nenter = [ { go = 'other end', speed = 1.0 } ]\n";
    // Menge: vertices, no edges, no obstacles; a level, the slope and another level.
    ground << "8\n-1 0\n1 0\n1 3\n-1 3\n1 13\n-1 13\n1 16\n-1 16\n0\n0\nfloor 3\n"
              "0 1.5 4 0 1 2 3 0 0 0 0 0\n0 8 4 3 2 4 5 0 0.5 -1.5 0 0\n0 14.5 4 5 4 6 7 0 0 5 0 0\n";
    const char *low = "[0.0, 0.0, -0.5]\n", *high = "[0.0, 5.0, -15.5]\n";
    scenario << "name = 'slope'\n[stage]\nseconds = 60.0\n[[characters]]\nname = 'people'\ncharacter = 'citizen'\n"
                "[places]\nstart = "
             << (up ? low : high) << "'other end' = " << (up ? high : low) << "[navigation]\narea = 'slope.nav'\n"
             << share << "[[agents]]\nclass = 'people'\nmachine = 'walker.toml'\nfrom = ['start']\nwithin_m = 0.0\n";
    machine.close(), ground.close(), scenario.close();
    return load_scenario(folder + "/slope.toml");
}

// The seconds in which it goes 6 m over the ground, on the slope.
double seconds_on(const Scenario &scenario)
{
    World world(scenario, 1, false);
    const auto passes = [&](double y_m) {
        const bool above = world.run().place_of(0)[1] > y_m;
        while (world.run().decided_s() < 60 && (world.run().place_of(0)[1] > y_m) == above) world.run().tick();
        return world.run().decided_s();
    };
    world.run().decide(0.5);
    const bool up = world.run().place_of(0)[1] < 2;
    const double begun_s = passes(up ? 1 : 4);
    return passes(up ? 4 : 1) - begun_s;
}

struct Walked {
    double own = 0, seen = 0;  // m/s
};

Walked walked(const Scenario &scenario, uint64_t seed)
{
    World world(scenario, 1, false, seed);
    world.run().decide(5);
    const double before_m = world.run().place_of(0)[2], before_s = world.run().decided_s();
    world.run().decide(15);
    Walked made;
    made.seen = (world.run().place_of(0)[2] - before_m) / (world.run().decided_s() - before_s);
    check(clq_stage_get_variable(world.run().handle(), world.run().agent_of(0), "own", &made.own));
    return made;
}

TEST(OwnSpeeds, AreWalkedWhereNoSpeedIsNamed)
{
    const Scenario scenario = corridor(""), hurried = corridor(", speed = '1.4 * own_speed'");
    double least = 9, most = 0;
    for (uint64_t seed = 1; seed <= seeds; ++seed) {
        const Walked made = walked(scenario, seed);
        EXPECT_NEAR(made.seen, made.own, 0.01) << "seed " << seed;
        EXPECT_EQ(walked(hurried, seed).own, made.own);
        EXPECT_NEAR(walked(hurried, seed).seen, 1.4 * made.own, 0.01) << "seed " << seed;
        least = std::fmin(least, made.own), most = std::fmax(most, made.own);
    }
    EXPECT_LT(least, 1.2);
    EXPECT_GT(most, 1.5);
}

TEST(OwnSpeeds, AreTheScenariosSharesOnStairs)
{
    for (const bool up : {true, false}) {
        const char *key = up ? "climbing" : "descending";
        const double level_s = seconds_on(slope(up, std::string(key) + " = 1.0\n"));
        EXPECT_NEAR(level_s, 6, 0.4) << key;
        EXPECT_NEAR(level_s / seconds_on(slope(up, std::string(key) + " = 0.7\n")), 0.7, 0.03) << key;
        EXPECT_NEAR(level_s / seconds_on(slope(up, "")), up ? 0.455 : 0.518, 0.03) << key;
    }
}

}  // namespace
}  // namespace staged_test
