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

}  // namespace
}  // namespace staged_test
