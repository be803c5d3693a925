// People of a run turn their heads to what their machines say that they look at.
#include <cmath>
#include <filesystem>
#include <fstream>

#include "tests/staged/staged_world.h"

namespace staged_test
{
namespace
{

using namespace scenes;

const char listener[] = R"(
machine = "listener"
[states.waits]
initial = true
transitions = [ { after = 2, to = "listens" } ]
[states.listens]
enter = [ { look = "speakers" } ]
leave = [ { look = "none" } ]
transitions = [ { after = 3, to = "waits" } ]
)";

const char speaker[] = R"(
machine = "speaker"
[states.stands]
)";

// Both look along +z; the speaker stands on the listener's left.
const char two_standing[] = R"(
name = "two who stand"
[stage]
seconds = 6.0
[[characters]]
name = "people"
character = "citizen"
[places]
"here" = [0.0, 0.0, 0.0]
"there" = [2.0, 0.0, 2.0]
[[agents]]
name = "listeners"
class = "people"
machine = "listener.toml"
from = ["here"]
within_m = 0.0
heading_deg = 0.0
[[agents]]
name = "speakers"
class = "people"
machine = "speaker.toml"
from = ["there"]
within_m = 0.0
heading_deg = 0.0
)";

const char guest[] = R"(
machine = "speaker"
[states.stands]
initial = true
transitions = [ { after = 2, to = "left" } ]
[states.left]
enter = [ { call = "leave" } ]
)";

Scenario listening(const char *other = speaker)
{
    // Tests run side by side, so each has its own.
    const std::string folder =
        testing::TempDir() + "claque_heads_" + testing::UnitTest::GetInstance()->current_test_info()->name();
    std::filesystem::create_directories(folder);
    std::ofstream(folder + "/listener.toml") << listener;
    std::ofstream(folder + "/speaker.toml") << other;
    std::ofstream(folder + "/scenario.toml") << two_standing;
    return load_scenario(folder + "/scenario.toml");
}

// Degrees to the left of +z in which the head of a person looks.
double head_deg(World &world, uint32_t person, double time_s)
{
    world.scene->place(time_s);
    const staged::Person &one = world.run().people().all()[person];
    const uint32_t head = clq_template_find_node(world.run().people().member(one).tmpl, "head");
    double m[16] = {};
    check(clq_actor_get_node(world.run().crowd(), one.actor, head, time_s, m));
    return std::atan2(m[8], m[10]) * 180 / 3.14159265358979;
}

TEST(HeadsOfARun, TurnToWhatPeopleLookAt)
{
    World world(listening(), 1, false);
    EXPECT_NEAR(head_deg(world, 0, 1.5), 0, 12) << "it waits";
    EXPECT_NEAR(head_deg(world, 0, 3.5), 45, 12) << "it looks at the speaker";
    EXPECT_NEAR(head_deg(world, 1, 3.6), 0, 12) << "the speaker looks ahead";
    EXPECT_NEAR(head_deg(world, 0, 5.8), 0, 12) << "it waits again";
}

TEST(HeadsOfARun, AreHeldWhereTheyAreWithTheRestOfARun)
{
    World run(listening(), 1, false), other(listening(), 1, false);
    run.scene->place(3.5);
    other.scene->restore(run.scene->save());
    EXPECT_EQ(head_deg(other, 0, 3.6), head_deg(run, 0, 3.6));
    EXPECT_NEAR(head_deg(other, 0, 4.0), 45, 12);
    EXPECT_NEAR(head_deg(other, 0, 5.9), 0, 12);
}

// No track ends here: a person that stands is away when it leaves, and not before.
TEST(PeopleThatStand, AreNotSeenOnceTheyLeft)
{
    World world(listening(guest), 1, false);
    const auto seen = [&](double time_s) {
        world.show(time_s);
        clq_view_stats stats = clq_view_stats_init();
        check(clq_view_get_stats(world.view.get(), &stats));
        return stats.visible;
    };
    EXPECT_EQ(seen(1.5), 2u);
    EXPECT_EQ(seen(3.5), 1u);
    EXPECT_EQ(world.run().counts().left, 1u);
}

}  // namespace
}  // namespace staged_test
