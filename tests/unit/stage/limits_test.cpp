// No queue of a stage grows without a bound: tasks, messages and commands have limits, and what is pointless makes
// room.
#include "tests/unit/stage/stage_world.h"

namespace
{

constexpr uint64_t at_least = uint64_t(1) << 20;  // of tasks, messages and commands

bool says(const char *words) { return std::string(clq_last_error()).find(words) != std::string::npos; }

// Each agent answers a call by a call to all.
const char *const echo = R"toml(
machine = "echo"
[events]
call = 1
[states.a]
transitions = [ { on = "call", do = [ { send = "call" } ] } ]
)toml";

TEST(StageLimits, EventsThatSendEventsEndWithALimitAndTheStageGoesOnWithoutTheirAgents)
{
    StageWorld world;
    const clq_machine machine = world.machine(echo);
    std::vector<clq_agent> agents;
    for (int i = 0; i < 300; ++i) agents.push_back(world.agent(machine, 0.1 * i));
    world.step(0.1);
    world.send("call", 0.12);
    clq_status status = CLQ_OK;
    int ticks = 0;
    for (; status == CLQ_OK && ticks < 40; ++ticks) status = clq_stage_step(world.stage, 0.15 + 0.05 * ticks);
    ASSERT_EQ(status, CLQ_LIMIT) << ticks;
    EXPECT_TRUE(says("the event call would bring")) << clq_last_error();
    EXPECT_TRUE(says("1067776 may wait")) << clq_last_error();
    EXPECT_LE(world.info().tasks, at_least + 64 * 300);
    const double decided_s = clq_stage_get_decided_s(world.stage);
    EXPECT_EQ(clq_stage_step(world.stage, decided_s + 0.05), CLQ_LIMIT) << "the task waits, and there is no more room";
    EXPECT_EQ(clq_stage_get_decided_s(world.stage), decided_s);
    for (const clq_agent agent : agents) EXPECT_EQ(clq_stage_remove_agent(world.stage, agent), CLQ_OK);
    world.step(decided_s + 1);
}

// Each change of state leaves a time behind that no longer matters.
TEST(StageLimits, TasksThatHaveBecomePointlessMakeRoom)
{
    StageWorld world;
    const clq_machine machine = world.machine(machine_text(R"toml(
[states.a]
initial = true
transitions = [ { after = 0.05, to = "b" }, { after = 1e6, to = "b" } ]
[states.b]
transitions = [ { after = 0.05, to = "a" }, { after = 1e6, to = "a" } ]
)toml"));
    for (int i = 0; i < 500; ++i) world.agent(machine);
    for (int second = 1; world.info().transitions < at_least + 64 * 500 + 100000; ++second) {
        ASSERT_EQ(clq_stage_step(world.stage, second), CLQ_OK) << clq_last_error();
        ASSERT_LT(second, 400);
    }
    EXPECT_LE(world.info().tasks, at_least + 64 * 500);
}

TEST(StageLimits, MessagesThatNoStepTakesEndWithALimit)
{
    StageWorld world;
    const clq_agent agent = world.agent(world.machine(echo));
    clq_stage_event event = clq_stage_event_init();
    event.name = "call", event.to = agent;
    for (uint64_t i = 0; i < at_least + 64; ++i) ASSERT_EQ(clq_stage_send(world.stage, &event), CLQ_OK);
    EXPECT_EQ(clq_stage_send(world.stage, &event), CLQ_LIMIT);
    EXPECT_TRUE(says("1048640 messages wait for clq_stage_step, and here are 1 more")) << clq_last_error();
    const bool in_view = true;
    EXPECT_EQ(clq_stage_tell_view(world.stage, &agent, &in_view, 1, 0), CLQ_LIMIT);
    EXPECT_EQ(clq_stage_remove_agent(world.stage, agent), CLQ_OK);
    world.step(0.1);
    world.agent(world.machine(machine_text("[states.a]\n")));
    world.send("go", 0.2);
}

TEST(StageLimits, CommandsThatNothingAppliesEndWithALimit)
{
    std::string plays;
    for (int i = 0; i < 100; ++i) plays += "{ play = \"fast\" }, ";
    StageWorld world;
    const char *const state = "[states.a]\ninitial = true\ntransitions = [ { after = 0.05, to = \"a\", do = [ ";
    world.actor_agent(world.machine(machine_text(state + plays + "] } ]\n")));
    clq_status status = CLQ_OK;
    double until_s = 0;
    while (status == CLQ_OK && until_s < 1000) status = clq_stage_step(world.stage, until_s += 1);
    ASSERT_EQ(status, CLQ_LIMIT);
    EXPECT_TRUE(says("commands wait for clq_stage_apply")) << clq_last_error();
    EXPECT_LE(world.info().commands, at_least + 4096);
    EXPECT_GT(world.info().commands, at_least);
    world.apply(clq_stage_get_decided_s(world.stage));
    world.step(until_s + 1);
}

TEST(StageLimits, AStepDecidesAMillionTicksAndNoMore)
{
    clq_stage_def def = clq_stage_def_init();
    def.tick_s = 0.0625;
    StageWorld world(&def);
    world.step(0.125);
    EXPECT_EQ(clq_stage_step(world.stage, 62500.1875), CLQ_LIMIT);
    EXPECT_TRUE(says("1000001 ticks of 0.0625 s are missing up to 62500.2 s: a step decides 1000000 at most"))
        << clq_last_error();
    EXPECT_EQ(clq_stage_get_decided_s(world.stage), 0.125);
    world.step(62500.125);
    EXPECT_EQ(clq_stage_get_decided_s(world.stage), 62500.125);
}

}  // namespace
