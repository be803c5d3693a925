// A person that comes into view of the recorded camera hears it, whichever frames are drawn.
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>

#include "tests/staged/staged_world.h"

namespace staged_test
{
namespace
{

using namespace scenes;

const char machine[] = R"(
machine = "guest"
[variables]
since = 0
[states.waits]
initial = true
transitions = [ { on = "unseen", to = "hidden" } ]
[states.hidden]
transitions = [ { on = "seen", to = "shown", do = [ { set = "since", to = "clock" } ] } ]
[states.shown]
transitions = [ { on = "unseen", to = "hidden" } ]
)";

// Twelve people to the west and as many to the east of a camera that looks at the west, and from 4 s to 5 s turns to
// the east.
const char scenario[] = R"(
name = "two sides"
[stage]
seconds = 10.0
[[characters]]
name = "guests"
character = "citizen"
[[agents]]
class = "guests"
machine = "guest.toml"
count = 12
area = [-12.0, -2.0, -8.0, 2.0]
[[agents]]
class = "guests"
machine = "guest.toml"
count = 12
area = [8.0, -2.0, 12.0, 2.0]
[navigation]
rectangle = [-15.0, -5.0, 15.0, 5.0]
[camera]
far_m = 100.0
[[camera.keys]]
time_s = 0.0
eye = [0.0, 2.0, 0.0]
target = [-10.0, 1.0, 0.0]
fov_deg = 50.0
near_m = 0.2
[[camera.keys]]
time_s = 4.0
eye = [0.0, 2.0, 0.0]
target = [-10.0, 1.0, 0.0]
fov_deg = 50.0
near_m = 0.2
[[camera.keys]]
time_s = 5.0
eye = [0.0, 2.0, 0.0]
target = [10.0, 1.0, 0.1]
fov_deg = 50.0
near_m = 0.2
[[camera.keys]]
time_s = 10.0
eye = [0.0, 2.0, 0.0]
target = [10.0, 1.0, 0.1]
fov_deg = 50.0
near_m = 0.2
)";

Scenario two_sides()
{
    const std::filesystem::path folder = testing::TempDir() + "claque_two_sides";
    std::filesystem::create_directories(folder);
    std::ofstream(folder / "guest.toml") << machine;
    std::ofstream(folder / "two_sides.toml") << scenario;
    return load_scenario((folder / "two_sides.toml").string());
}

std::string state_of(const staged::Run &run, uint32_t person)
{
    clq_agent_info info = clq_agent_info_init();
    check(clq_stage_get_agent(run.handle(), run.agent_of(person), &info));
    return info.state;
}

size_t count_in(const staged::Run &run, uint32_t first, const std::string &state)
{
    size_t count = 0;
    for (uint32_t i = first; i < first + 12; ++i) count += state_of(run, i) == state;
    return count;
}

// When each of those to the east heard that it is seen.
std::vector<double> heard_s(const staged::Run &run)
{
    std::vector<double> all(12);
    for (uint32_t i = 0; i < 12; ++i)
        check(clq_stage_get_variable(run.handle(), run.agent_of(12 + i), "since", &all[i]));
    return all;
}

TEST(SightsOfARun, AreToldAfterTheLead)
{
    World world(two_sides(), 1, false);
    world.show(2);
    world.scene->rest();
    EXPECT_EQ(count_in(world.run(), 0, "waits"), 12u) << "those in view count as seen from the beginning";
    EXPECT_EQ(count_in(world.run(), 12, "hidden"), 12u);
    world.show(4);
    EXPECT_EQ(count_in(world.run(), 12, "shown"), 0u) << "the camera has not turned";
    world.show(8);
    EXPECT_EQ(count_in(world.run(), 0, "hidden"), 12u);
    EXPECT_EQ(count_in(world.run(), 12, "shown"), 12u);
    EXPECT_EQ(world.run().info().late_messages, 0u);
}

TEST(SightsOfARun, AreTheSameForAnyFramesAndFlows)
{
    std::vector<std::vector<double>> heard;
    for (const bool apart : {false, true})
        for (const double step_s : {0.04, 0.7, 8.4}) {
            World world(two_sides(), apart ? 2 : 1, apart);
            for (int i = 0; i * step_s < 8.4 + step_s / 2; ++i) world.scene->place(i * step_s);
            world.scene->place(8.4);
            world.scene->rest();
            heard.push_back(heard_s(world.run()));
            EXPECT_EQ(world.run().info().late_messages, 0u);
            EXPECT_EQ(count_in(world.run(), 12, "shown"), 12u);
        }
    for (const std::vector<double> &times : heard) EXPECT_EQ(times, heard[0]);
    EXPECT_GT(heard[0][0], 5);
}

TEST(SightsOfARun, GoOnAfterARestore)
{
    std::vector<double> heard;
    std::vector<uint8_t> bytes;
    {
        World world(two_sides(), 1, false);
        world.show(5);  // what is seen now has not been heard
        bytes = world.scene->save();
        world.show(8);
        world.scene->rest();
        heard = heard_s(world.run());
    }
    World again(two_sides(), 1, true);
    again.scene->restore(bytes);
    again.show(8);
    again.scene->rest();
    EXPECT_EQ(heard_s(again.run()), heard);
    EXPECT_EQ(count_in(again.run(), 12, "shown"), 12u);
}

}  // namespace
}  // namespace staged_test
