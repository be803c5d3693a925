// What the stage decides is what the crowd shows; ends and markers are where the crowd has them.
#include <cmath>

#include "tests/unit/stage/stage_world.h"

namespace
{

std::vector<clq_active_clip> shown(StageWorld &world, double time_s) { return world.arm.shown(time_s); }

TEST(Applied, CommandsAreWhatTheCrowdShows)
{
    StageWorld world;
    world.actor_agent(world.machine(R"toml(
machine = "m"
[masks]
hand = { nodes = ["hand"] }
[states.a]
initial = true
enter = [ { play = "fast", fade = 0, phase = 0.5, speed = 2 } ]
transitions = [ { after = 1.0, to = "b" } ]
[states.b]
enter = [ { play = "bent", fade = 0.5, curve = "linear" }, { gesture = "wave", mask = "hand", loops = 0, fade_in = 0 } ]
transitions = [ { after = 1.0, to = "c" } ]
[states.c]
enter = [ { end_gesture = true, fade = 0.25 } ]
)toml"));
    world.step(4);
    EXPECT_EQ(world.apply(0.5).commands, 1u);
    std::vector<clq_active_clip> now = shown(world, 0.5);
    ASSERT_EQ(now.size(), 1u);
    EXPECT_EQ(now[0].clip, uint32_t(Arm::fast));
    EXPECT_NEAR(now[0].clip_time_s, 0.5, 1e-5);  // 0.5 + 2 * 0.5, of a loop of 1 s
    EXPECT_EQ(world.apply(1.25).commands, 2u);
    now = shown(world, 1.25);
    ASSERT_EQ(now.size(), 3u);
    EXPECT_EQ(now[1].clip, uint32_t(Arm::bent));
    EXPECT_NEAR(now[1].weight, 0.5, 1e-4);
    EXPECT_EQ(now[2].clip, uint32_t(Arm::wave));
    world.apply(4);
    now = shown(world, 3);
    ASSERT_EQ(now.size(), 1u) << "the gesture has ended";
    EXPECT_EQ(now[0].clip, uint32_t(Arm::bent));
    EXPECT_EQ(world.apply(4).commands, 0u);
}

TEST(Applied, EndsAndMarkersAreThoseThatTheCrowdReports)
{
    StageWorld world;
    const clq_agent agent = world.actor_agent(world.machine(R"toml(
machine = "m"
[variables]
ends = 0.0
marks = 0.0
[states.a]
initial = true
enter = [ { play = "slow", fade = 0, phase = [0, 1], speed = [0.7, 1.6] } ]
transitions = [
    { end = true, do = [ { set = "ends", to = "ends + clock" } ] },
    { marker = "down", do = [ { set = "marks", to = "marks + clock" } ] },
    { after = 7.3, to = "b" },
]
[states.b]
enter = [ { play = ["fast"], fade = 0, phase = 0.3, speed = 0.9 } ]
transitions = [
    { end = true, do = [ { set = "ends", to = "ends + clock" } ] },
    { marker = "down", do = [ { set = "marks", to = "marks + clock" } ] },
]
)toml"));
    ASSERT_EQ(clq_actor_set_watched(world.arm.crowd, world.arm.actor, true), CLQ_OK);
    world.step(20);
    double ends = 0, marks = 0;
    int count = 0;
    for (int frame = 1; frame <= 600; ++frame) {
        const double t = frame / 30.0;
        world.apply(t);
        for (const clq_event &event : world.arm.events((frame - 1) / 30.0, t)) {
            ends += event.kind == CLQ_EVENT_CLIP_END ? event.time_s : 0;
            marks += event.kind == CLQ_EVENT_MARKER ? event.time_s : 0;
            ++count;
        }
    }
    EXPECT_GT(count, 25);
    EXPECT_NEAR(world.variable(agent, "ends"), ends, 1e-6);
    EXPECT_NEAR(world.variable(agent, "marks"), marks, 1e-6);
}

TEST(Applied, WhatIsNotDecidedIsRefusedOrCounted)
{
    StageWorld world;
    world.actor_agent(world.machine("machine = \"m\"\n[states.a]\nenter = [ { play = \"fast\" } ]\n"));
    world.step(1);
    EXPECT_EQ(clq_stage_apply(world.stage, world.arm.crowd, 1.01, nullptr), CLQ_ARGUMENT);
    EXPECT_STREQ(clq_last_error(), "clq_stage_apply: time_s is 1.01, and only what happens up to 1 is decided");
    EXPECT_EQ(clq_stage_apply(world.stage, world.arm.crowd, 1, nullptr), CLQ_OK);
    clq_stage_def def = clq_stage_def_init();
    def.mode = CLQ_STAGE_LIVE;
    StageWorld live(&def);
    live.actor_agent(live.machine("machine = \"m\"\n[states.a]\nenter = [ { play = \"fast\" } ]\n"));
    EXPECT_EQ(live.apply(0.75).behind_s, 0.75);
    live.step(1);
    EXPECT_EQ(live.apply(0.8).late, 1u);
}

TEST(Applied, FadesWithoutRoomAreCut)
{
    StageWorld world;
    world.actor_agent(world.machine(R"toml(
machine = "m"
[states.a]
initial = true
while = { every = 0.1, do = [ { play = ["fast", "slow", "bent"], fade = 2 } ] }
)toml"));
    world.step(1);
    const clq_stage_applied applied = world.apply(1);
    EXPECT_EQ(applied.commands, 9u);
    EXPECT_GT(applied.cut, 0u);
    EXPECT_EQ(applied.refused, 0u);
}

TEST(Applied, CommandsForAnActorThatIsGoneAreCounted)
{
    StageWorld world;
    world.actor_agent(world.machine("machine = \"m\"\n[states.a]\nenter = [ { play = \"fast\" } ]\n"));
    world.step(1);
    ASSERT_EQ(clq_actor_destroy(world.arm.crowd, world.arm.actor), CLQ_OK);
    EXPECT_EQ(world.apply(1).refused, 1u);
}

struct Calls {
    std::vector<double> times, values;
    clq_crowd *crowd = nullptr;
    static void take(void *user, const clq_action_call *call)
    {
        Calls &calls = *static_cast<Calls *>(user);
        calls.times.push_back(call->time_s), calls.values.push_back(call->value), calls.crowd = call->crowd;
        if (calls.times.size() == 2) throw 3;
    }
};

TEST(HostAction, IsCalledWhenItIsDecidedAndWhenItIsShown)
{
    StageWorld world;
    Calls decided, displayed;
    clq_action_def def = clq_action_def_init();
    def.name = "ring", def.decide = Calls::take, def.user = &decided;
    ASSERT_EQ(clq_stage_add_action(world.stage, &def), CLQ_OK);
    EXPECT_EQ(clq_stage_add_action(world.stage, &def), CLQ_ARGUMENT);
    def = clq_action_def_init();
    def.name = "flash", def.show = Calls::take, def.user = &displayed;
    ASSERT_EQ(clq_stage_add_action(world.stage, &def), CLQ_OK);
    world.actor_agent(world.machine(R"toml(
machine = "m"
[states.a]
while = { every = 0.5, do = [ { call = "ring", value = "2 * clock" }, { call = "flash", value = 3 } ] }
)toml"));
    world.step(1.7);
    ASSERT_EQ(decided.times.size(), 3u) << "what a callback throws does not end the step";
    EXPECT_NEAR(decided.values[2], 3, 1e-5);
    EXPECT_EQ(decided.crowd, nullptr);
    EXPECT_TRUE(displayed.times.empty());
    world.apply(1.2);
    ASSERT_EQ(displayed.times.size(), 2u);
    EXPECT_NEAR(displayed.times[1], 1, 1e-5);
    EXPECT_EQ(displayed.crowd, world.arm.crowd);
}

}  // namespace
