// Events go to one agent, a class, a radius, or all; they spread; they do not depend on who sends them when.
#include <cmath>

#include "tests/unit/stage/stage_world.h"

namespace
{

const char *const listener = R"toml(
machine = "listener"
[variables]
heard = 0.0
last = -1.0
far = -1.0
[events]
call = 1
pass = 1
[states.a]
transitions = [
    { on = "call", do = [
        { set = "heard", to = "heard + 1" }, { set = "last", to = "value" }, { set = "far", to = "distance" } ] },
    { on = "pass", do = [ 
        { send = "call", radius = 5, class = "owl", delay = 0.2, value = "value + 1", per_m = 0.1 } ] },
]
)toml";

struct Row {
    Row()
    {
        const clq_machine machine = world.machine(listener);
        for (int i = 0; i < 20; ++i) agents.push_back(world.agent(machine, i, i % 2 ? "owl" : "cat"));
        world.step(0.1);
    }
    std::string heard() const
    {
        std::string all;
        for (const clq_agent agent : agents) all += std::to_string(static_cast<int>(world.variable(agent, "heard")));
        return all;
    }
    StageWorld world;
    std::vector<clq_agent> agents;
};

TEST(StageEvent, ReachesThoseThatItIsFor)
{
    Row row;
    clq_stage_event event = clq_stage_event_init();
    event.name = "call", event.at_s = 0.15, event.to = row.agents[3];
    EXPECT_EQ(clq_stage_send(row.world.stage, &event), CLQ_OK);
    row.world.step(0.2);
    EXPECT_EQ(row.heard(), "00010000000000000000");
    event = clq_stage_event_init();
    event.name = "call", event.at_s = 0.25, event.to_class = "cat", event.sender = row.agents[0];
    EXPECT_EQ(clq_stage_send(row.world.stage, &event), CLQ_OK);
    row.world.step(0.3);
    EXPECT_EQ(row.heard(), "00111010101010101010") << "the sender does not get it";
    event = clq_stage_event_init();
    event.name = "call", event.at_s = 0.35, event.radius_m = 2.5f, event.position[0] = 10;
    EXPECT_EQ(clq_stage_send(row.world.stage, &event), CLQ_OK);
    row.world.step(0.4);
    EXPECT_EQ(row.heard(), "00111010212120101010");
    EXPECT_EQ(row.world.variable(row.agents[8], "far"), 2);
    row.world.send("call", 0.45);
    row.world.step(0.5);
    EXPECT_EQ(row.heard(), "11222121323231212121");
}

TEST(StageEvent, SpreadsWithTheDistance)
{
    Row row;
    clq_stage_event event = clq_stage_event_init();
    event.name = "call", event.at_s = 0.2, event.delay_s_per_m = 0.5f;
    EXPECT_EQ(clq_stage_send(row.world.stage, &event), CLQ_OK);
    for (int i = 0; i < 8; ++i) {
        row.world.step(0.2 + 0.5 * i);
        EXPECT_EQ(row.heard(),
                  std::string(static_cast<size_t>(i) + 1, '1') + std::string(19 - static_cast<size_t>(i), '0'));
    }
}

TEST(StageEvent, OfAnAgentArrivesAtItsNeighboursLater)
{
    Row row;
    row.world.send_to(row.agents[9], "pass", 0.3, 6);
    row.world.step(0.65);
    EXPECT_EQ(row.heard(), "00000000000000000000");
    row.world.step(0.75);
    EXPECT_EQ(row.heard(), "00000001000100000000") << "0.2 s and 2 m later";
    row.world.step(2);
    EXPECT_EQ(row.heard(), "00000101000101000000") << "within 5 m, owls, not itself";
    EXPECT_EQ(row.world.variable(row.agents[7], "last"), 7);
    EXPECT_EQ(row.world.variable(row.agents[7], "far"), 2);
}

TEST(StageEvent, IsRefusedWithNamesThatNothingDeclares)
{
    Row row;
    clq_stage_event event = clq_stage_event_init();
    event.name = "cal";
    EXPECT_EQ(clq_stage_send(row.world.stage, &event), CLQ_ARGUMENT);
    EXPECT_STREQ(clq_last_error(), "clq_stage_send: no machine declares an event 'cal'");
    event.name = "call", event.to_class = "dog";
    EXPECT_EQ(clq_stage_send(row.world.stage, &event), CLQ_ARGUMENT);
    event.to_class = nullptr, event.to = {21};
    EXPECT_EQ(clq_stage_send(row.world.stage, &event), CLQ_STALE_ID);
    EXPECT_EQ(clq_stage_remove_agent(row.world.stage, row.agents[4]), CLQ_OK);
    event.to = row.agents[4];
    EXPECT_EQ(clq_stage_send(row.world.stage, &event), CLQ_STALE_ID);
    event = clq_stage_event_init();
    event.name = "call", event.at_s = NAN;
    EXPECT_EQ(clq_stage_send(row.world.stage, &event), CLQ_ARGUMENT);
    EXPECT_EQ(clq_stage_set_variable(row.world.stage, row.agents[0], "herd", 1, 0), CLQ_ARGUMENT);
}

TEST(StageEvent, ThatComesTooLateHappensInTheNextTickAndIsCounted)
{
    Row row;
    row.world.step(1);
    row.world.send_to(row.agents[0], "call", 0.5);
    row.world.step(1.04);
    EXPECT_EQ(row.heard()[0], '0');
    row.world.step(1.05);
    EXPECT_EQ(row.heard()[0], '1');
    EXPECT_EQ(row.world.info().late_messages, 1u);
}

TEST(StageEvent, SeenAndUnseenComeOncePerChange)
{
    StageWorld world;
    const clq_agent agent = world.agent(world.machine(R"toml(
machine = "m"
[variables]
log = 0.0
[states.a]
transitions = [ { on = "seen", do = [ { set = "log", to = "10 * log + 1" } ] },
    { on = "unseen", do = [ { set = "log", to = "10 * log + 2" } ] } ]
)toml"));
    double at_s = 0.1;
    for (const bool in_view : {true, false, false, true}) {
        EXPECT_EQ(clq_stage_tell_view(world.stage, &agent, &in_view, 1, at_s), CLQ_OK);
        at_s += 0.1;
    }
    world.step(1);
    EXPECT_EQ(world.variable(agent, "log"), 21);
}

TEST(Timetable, SendsItsEventsAgainAndAgain)
{
    Row row;
    const auto add = [&](const std::string &text) {
        clq_stage_text source = clq_stage_text_init();
        source.text = text.data(), source.text_bytes = text.size(), source.name = "t.toml";
        return clq_stage_add_timetable(row.world.stage, &source, 1);
    };
    EXPECT_EQ(add("[[event]]\nat = 0.5\nsend = \"call\"\nevery = 0.5\ntimes = 3\nradius = 1.5\nposition = [5, 0, 0]\n"
                  "[[event]]\nat = 1.25\nsend = \"call\"\nclass = \"owl\"\n"),
              CLQ_OK)
        << clq_last_error();
    row.world.step(2.2);
    EXPECT_EQ(row.heard(), "00002220000000000000");
    row.world.step(9);
    EXPECT_EQ(row.heard(), "01013431010101010101");
    EXPECT_EQ(add("[[event]]\nat = -1e9\nevery = 0.01\nsend = \"call\"\nradius = 0.5\n"), CLQ_OK);
    row.world.step(9.05);
    const double heard = row.world.variable(row.agents[0], "heard");
    EXPECT_TRUE(heard >= 5 && heard <= 7) << heard << ": of those that are over one happens, and five are in the tick";
    EXPECT_EQ(add("[[event]]\nat = 0.5\nsend = \"cal\"\n"), CLQ_FORMAT);
    EXPECT_STREQ(clq_last_error(),
                 "clq_stage_add_timetable: t.toml, line 3, column 8: no machine declares an event 'cal'");
    EXPECT_EQ(add("[[event]]\nsend = \"call\"\n"), CLQ_FORMAT);
    EXPECT_EQ(add("[[event]]\nat = 1\nsend = \"call\"\ntimes = 2\n"), CLQ_FORMAT);
}

// A walker that is on its way to the sender of one event hears others.
TEST(Events, ThatNoTransitionTakesAreForgottenWithTheirValueAndOrigin)
{
    StageWorld world;
    const clq_agent agent = world.agent(world.machine(R"toml(
machine = "m"
[variables]
heard = -1.0
far = -1.0
[events]
call = 1
noise = 1
tell = 1
[states.a]
transitions = [
    { on = "call", if = "value < 10", do = [ { set = "heard", to = "value" } ] },
    { if = "clock > 2 and far < 0", do = [ { set = "heard", to = "value" }, { set = "far", to = "distance" } ] },
]
)toml"));
    clq_stage_event event = clq_stage_event_init();
    event.name = "call", event.value = 3, event.at_s = 0.5, event.position[0] = 4;
    ASSERT_EQ(clq_stage_send(world.stage, &event), CLQ_OK);
    event.value = 12, event.at_s = 1, event.position[0] = 30;
    ASSERT_EQ(clq_stage_send(world.stage, &event), CLQ_OK);
    event.name = "noise", event.at_s = 1.5;
    ASSERT_EQ(clq_stage_send(world.stage, &event), CLQ_OK);
    world.step(4);
    EXPECT_EQ(world.variable(agent, "heard"), 3);
    EXPECT_EQ(world.variable(agent, "far"), 4);
}

TEST(StageEvent, IsLateIfItsTimeIsDecidedWhenItComes)
{
    Row row;
    row.world.step(1);
    for (const double at_s : {0.5, 1.0, 1.0 + 1e-6, 1.02, 1.3}) row.world.send("call", at_s);
    row.world.step(1.05);
    EXPECT_EQ(row.world.info().late_messages, 2u);
    row.world.step(2);
    EXPECT_EQ(row.world.info().late_messages, 2u);
    EXPECT_EQ(row.heard(), "55555555555555555555");
}

}  // namespace
