// Every kind of transition.
#include <cmath>

#include "tests/unit/stage/stage_world.h"

namespace
{

TEST(Transition, ByEventTakesTheFirstWhoseConditionHolds)
{
    StageWorld world;
    const clq_agent agent = world.agent(world.machine(machine_text(R"toml(
[states.a]
initial = true
transitions = [ { on = "go", if = "value > 5", to = "b" },
    { on = "go", if = "value > 2", to = "c" }, { on = "back", to = "b" } ]
[states.b]
[states.c]
)toml")));
    world.send_to(agent, "go", 0.31, 1);
    world.step(0.4);
    EXPECT_EQ(world.state(agent), "a") << "no condition holds: the event is forgotten";
    world.send_to(agent, "go", 0.52, 3);
    world.step(1);
    EXPECT_EQ(world.state(agent), "c");
    EXPECT_EQ(world.entered_s(agent), 0.52) << "at its own time, not at that of the tick";
}

TEST(Transition, ByTimeComesAfterTheStateWasEntered)
{
    StageWorld world;
    const clq_agent agent = world.agent(world.machine(machine_text(R"toml(
[states.a]
initial = true
transitions = [ { after = 1.234, to = "b" } ]
[states.b]
transitions = [ { after = [1, 2], to = "c" } ]
[states.c]
)toml")));
    world.step(1.2);
    EXPECT_EQ(world.state(agent), "a");
    world.step(1.25);
    EXPECT_EQ(world.state(agent), "b");
    EXPECT_DOUBLE_EQ(world.entered_s(agent), 1e-6 + 1.234);
    world.step(3.3);
    EXPECT_EQ(world.state(agent), "c");
    const double stayed_s = world.entered_s(agent) - 1.234;
    EXPECT_TRUE(stayed_s > 1 && stayed_s < 2) << stayed_s;
}

TEST(Transition, ByTimeDoesNotOutliveItsState)
{
    StageWorld world;
    const clq_agent agent = world.agent(world.machine(machine_text(R"toml(
[states.a]
initial = true
transitions = [ { after = 1.0, to = "b" }, { on = "go", to = "a" } ]
[states.b]
)toml")));
    world.send_to(agent, "go", 0.7);
    world.step(1.4);
    EXPECT_EQ(world.state(agent), "a") << "it was entered again at 0.7 s";
    world.step(1.75);
    EXPECT_EQ(world.state(agent), "b");
    EXPECT_DOUBLE_EQ(world.entered_s(agent), 1.7);
}

TEST(Transition, ByConditionIsTakenAsSoonAsAVariableMakesItTrue)
{
    StageWorld world;
    const clq_agent agent = world.agent(world.machine(machine_text(R"toml(
[states.a]
initial = true
transitions = [ { if = "n >= 3 and not open", to = "b" }, { on = "go", do = [ { set = "n", to = "n + 1" } ] } ]
[states.b]
transitions = [ { if = "crowd.mood > 1", to = "c" } ]
[states.c]
transitions = [ { if = "open", to = "d" } ]
[states.d]
)toml")));
    for (int i = 0; i < 3; ++i) {
        EXPECT_EQ(world.state(agent), i ? "a" : "");
        world.send_to(agent, "go", 0.1 + 0.2 * i);
        world.step(0.2 + 0.2 * i);
    }
    EXPECT_EQ(world.state(agent), "b");
    EXPECT_EQ(clq_stage_set_variable(world.stage, {}, "mood", 2, 0.93), CLQ_OK);
    world.step(0.95);
    EXPECT_EQ(world.state(agent), "b");
    world.step(1);
    EXPECT_EQ(world.state(agent), "c") << "the next tick after a variable of the crowd has changed";
    EXPECT_EQ(clq_stage_set_variable(world.stage, agent, "open", 1, 1.53), CLQ_OK);
    world.step(1.55);
    EXPECT_EQ(world.state(agent), "d");
    EXPECT_EQ(world.entered_s(agent), 1.53);
}

TEST(Transition, ByConditionOnTimeIsCheckedFromTimeToTime)
{
    StageWorld world;
    const clq_agent agent = world.agent(world.machine(machine_text(R"toml(
[states.a]
initial = true
check = 0.2
transitions = [ { if = "time > 0.9", to = "b" } ]
[states.b]
)toml")));
    world.step(3);
    EXPECT_EQ(world.state(agent), "b");
    EXPECT_NEAR(world.entered_s(agent), 1.0, 1e-5);
}

TEST(Transition, AtTheEndOfAClipComesTheFadeBeforeIt)
{
    StageWorld world;
    const clq_agent agent = world.agent(world.machine(machine_text(R"toml(
[states.a]
initial = true
enter = [ { play = "slow", speed = 2, phase = 0.25, fade = 0 } ]
transitions = [ { end = true, before = 0.3, to = "b" } ]
[states.b]
enter = [ { play = "fast", fade = 0.3 } ]
transitions = [ { end = true, if = "n > 1", to = "c" }, { end = true, do = [ { set = "n", to = "n + 1" } ] } ]
[states.c]
)toml")));
    world.step(0.5);
    EXPECT_EQ(world.state(agent), "b");
    EXPECT_NEAR(world.entered_s(agent), 0.75 - 0.3, 2e-6) << "three quarters of 2 s at double speed";
    world.step(2.5);
    EXPECT_EQ(world.state(agent), "b") << "two loops have ended";
    EXPECT_EQ(world.variable(agent, "n"), 2);
    world.step(3.5);
    EXPECT_EQ(world.state(agent), "c");
    EXPECT_NEAR(world.entered_s(agent), 3.45, 3e-6);
}

TEST(Transition, AtAMarkerComesWheneverTheClipPassesIt)
{
    StageWorld world;
    const clq_agent agent = world.agent(world.machine(machine_text(R"toml(
[states.a]
initial = true
enter = [ { play = "slow", fade = 0 } ]
transitions = [ { marker = "down", do = [ { set = "log", to = "10 * log + floor(10 * time)" } ] } ]
)toml")));
    world.step(3.2);
    EXPECT_EQ(world.variable(agent, "log"), 10 * (10 * 5 + 12) + 25) << "at 0.5, 1.25, 2.5 s";
    world.step(3.5);
    EXPECT_EQ(world.variable(agent, "log"), 10 * (10 * (10 * 5 + 12) + 25) + 32);
}

TEST(While, ActsAgainAndAgainUntilTheStateIsLeft)
{
    StageWorld world;
    const clq_agent agent = world.agent(world.machine(machine_text(R"toml(
[states.a]
initial = true
while = { every = 0.5, do = [ { set = "n", to = "n + 1" } ] }
transitions = [ { on = "go", to = "b" } ]
[states.b]
)toml")));
    world.step(2.3);
    EXPECT_EQ(world.variable(agent, "n"), 4);
    world.send_to(agent, "go", 2.4);
    world.step(5);
    EXPECT_EQ(world.variable(agent, "n"), 4);
}

TEST(Choice, FollowsTheWeightsAndTheSeed)
{
    StageWorld world;
    const clq_machine machine = world.machine(machine_text(R"toml(
[states.a]
initial = true
transitions = [ { after = 0.1, to = ["b", "c"], weights = [1, 3] } ]
[states.b]
[states.c]
)toml"));
    std::vector<clq_agent> agents;
    for (uint64_t i = 0; i < 400; ++i) agents.push_back(world.agent(machine, 0, nullptr, i / 2));
    world.step(1);
    int chosen = 0;
    for (size_t i = 0; i < agents.size(); ++i) {
        chosen += world.state(agents[i]) == "c";
        EXPECT_EQ(world.state(agents[i]), world.state(agents[i ^ 1])) << "equal seeds give twins";
    }
    EXPECT_NEAR(chosen, 300, 40);
}

TEST(Runaway, IsStoppedAndReported)
{
    StageWorld world;
    const clq_agent agent = world.agent(world.machine(machine_text(R"toml(
[states.a]
initial = true
transitions = [ { if = "n * n >= 0", to = "b" } ]
[states.b]
transitions = [ { if = "n + 1 > n", to = "a" } ]
)toml")));
    world.step(0.2);
    EXPECT_EQ(world.info().runaways, 1u);
    EXPECT_EQ(world.state(agent), "a") << "after an even number of transitions";
    EXPECT_EQ(world.info().transitions, 32u);
}

}  // namespace
