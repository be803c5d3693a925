// Nested states and history.
#include "tests/unit/stage/stage_world.h"

namespace
{

const char *const nested = R"toml(
[states.out]
initial = true
enter = [ { set = "log", to = "10 * log + 1" } ]
leave = [ { set = "log", to = "10 * log + 2" } ]
transitions = [ { on = "go", to = "far", do = [ { set = "log", to = "10 * log + 9" } ] }, { on = "slow", to = "out" } ]
[states.out.states.in]
initial = true
enter = [ { set = "log", to = "10 * log + 3" } ]
leave = [ { set = "log", to = "10 * log + 4" } ]
[states.out.states.in.states.x]
initial = true
enter = [ { set = "log", to = "10 * log + 5" } ]
leave = [ { set = "log", to = "10 * log + 6" } ]
transitions = [ { on = "back", to = "y" } ]
[states.out.states.in.states.y]
[states.out.states.other]
transitions = [ { on = "back", to = "x" } ]
[states.far]
enter = [ { set = "log", to = "10 * log + 7" } ]
transitions = [ { on = "back", to = "out", history = "deep" }, { on = "slow", to = "out", history = "shallow" },
    { on = "go", to = "other" } ]
)toml";

TEST(Nesting, LeavesFromWithinAndEntersFromWithout)
{
    StageWorld world;
    const clq_agent agent = world.agent(world.machine(machine_text(nested)));
    world.step(0.1);
    EXPECT_EQ(world.state(agent), "x");
    EXPECT_EQ(world.variable(agent, "log"), 135);
    world.send_to(agent, "back", 0.2);
    world.step(0.3);
    EXPECT_EQ(world.state(agent), "y");
    EXPECT_EQ(world.variable(agent, "log"), 1356) << "only x is left";
    world.send_to(agent, "go", 0.4);
    world.step(0.5);
    EXPECT_EQ(world.state(agent), "far") << "a transition of an outer state";
    EXPECT_EQ(world.variable(agent, "log"), 135642.0 * 100 + 97);
}

TEST(Nesting, ATransitionToAStateRoundItEntersItAgain)
{
    StageWorld world;
    const clq_agent agent = world.agent(world.machine(machine_text(nested)));
    world.send_to(agent, "slow", 0.2);
    world.step(0.3);
    EXPECT_EQ(world.variable(agent, "log"), 135642135.0);
}

TEST(Nesting, ATransitionToAStateWithinDoesNotLeaveTheOuterOne)
{
    StageWorld world;
    const clq_agent agent = world.agent(world.machine(machine_text(R"toml(
[states.out]
initial = true
enter = [ { set = "log", to = "10 * log + 1" } ]
leave = [ { set = "log", to = "10 * log + 2" } ]
transitions = [ { on = "go", to = "b" } ]
[states.out.states.a]
initial = true
leave = [ { set = "log", to = "10 * log + 3" } ]
[states.out.states.b]
)toml")));
    world.send_to(agent, "go", 0.2);
    world.step(0.3);
    EXPECT_EQ(world.state(agent), "b");
    EXPECT_EQ(world.variable(agent, "log"), 13);
}

TEST(History, DeepReturnsAllTheWayAndShallowOneStep)
{
    StageWorld world;
    const clq_agent agent = world.agent(world.machine(machine_text(nested)));
    world.send_to(agent, "back", 0.2);  // to y
    world.send_to(agent, "go", 0.3);
    world.send_to(agent, "back", 0.4);
    world.step(0.5);
    EXPECT_EQ(world.state(agent), "y");
    world.send_to(agent, "go", 0.6);
    world.send_to(agent, "slow", 0.7);
    world.step(0.8);
    EXPECT_EQ(world.state(agent), "x") << "back in the state `in`, whose own initial state is entered";
    world.send_to(agent, "go", 0.9);
    world.send_to(agent, "go", 1.0);    // to other
    world.send_to(agent, "slow", 1.1);  // out again: initial
    world.step(1.2);
    EXPECT_EQ(world.state(agent), "x");
}

TEST(History, IsTheInitialStateBeforeAnythingWasLeft)
{
    StageWorld world;
    const clq_agent agent = world.agent(world.machine(machine_text(R"toml(
[states.a]
initial = true
transitions = [ { on = "go", to = "b", history = "deep" } ]
[states.b.states.c]
initial = true
[states.b.states.d]
transitions = [ { on = "go", to = "c" } ]
[states.b]
transitions = [ { on = "back", to = "d" }, { on = "slow", to = "a" } ]
)toml")));
    world.send_to(agent, "go", 0.2);
    world.step(0.3);
    EXPECT_EQ(world.state(agent), "c");
    world.send_to(agent, "back", 0.4);
    world.send_to(agent, "slow", 0.5);
    world.send_to(agent, "go", 0.6);
    world.step(1);
    EXPECT_EQ(world.state(agent), "d");
}

}  // namespace
