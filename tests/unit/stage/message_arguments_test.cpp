// Events, variables and timetables that cannot be are refused with what is wrong, and nothing happens.
#include <cmath>
#include <functional>

#include "tests/api/expect_refused.h"
#include "tests/unit/stage/stage_world.h"

namespace
{

class StageMessages : public testing::Test
{
protected:
    StageMessages()
    {
        const clq_machine machine = world_.machine(machine_text("[states.a]\ninitial = true\n"));
        agent_ = world_.agent(machine, 0, "owl");
        world_.step(0.1);
    }

    StageWorld world_;
    clq_stage *stage_ = world_.stage;
    clq_agent agent_{};
};

TEST_F(StageMessages, EventsWithWrongNumbersAreRefused)
{
    const auto wrong = [&](const char *sentence, const std::function<void(clq_stage_event &)> &breaks,
                           clq_status status = CLQ_ARGUMENT) {
        clq_stage_event event = clq_stage_event_init();
        event.name = "go", event.at_s = 0.2;
        breaks(event);
        expect_refused(clq_stage_send(stage_, &event), sentence, status);
    };
    using Event = clq_stage_event;
    wrong("the event has no name", [](Event &event) { event.name = nullptr; });
    wrong("at_s is not finite", [](Event &event) { event.at_s = INFINITY; });
    wrong("value is not finite", [](Event &event) { event.value = NAN; });
    wrong("position[2] is inf", [](Event &event) { event.position[2] = INFINITY; });
    for (const float number : {-1.0f, NAN, INFINITY})
        wrong("0 or more is wanted", [number](Event &event) { event.radius_m = number; });
    for (const float number : {-1.0f, NAN, 1.1e6f})
        wrong("0 to 1e6 is wanted", [number](Event &event) { event.delay_s_per_m = number; });
    wrong(
        "there is no agent 9", [](Event &event) { event.sender = {9}; }, CLQ_STALE_ID);
    const char *const both = "an event has `to` and conditions besides";
    wrong(both, [&](Event &event) { event.to = agent_, event.to_class = "owl"; });
    wrong(both, [&](Event &event) { event.to = agent_, event.radius_m = 3; });
    wrong("no agent and no machine has the class 'cat'", [](Event &event) { event.to_class = "cat"; });
    world_.step(1);
    EXPECT_EQ(world_.info().events, 0u);
}

TEST_F(StageMessages, VariablesAreFoundByNameAndKeepTheirKind)
{
    const auto set = [&](clq_agent agent, const char *name, double value) {
        return clq_stage_set_variable(stage_, agent, name, value, 0.2);
    };
    expect_refused(set(agent_, "m", 1), "there is no variable 'm'");
    expect_refused(set({}, "n", 1), "there is no variable 'n'");
    expect_refused(set({7}, "n", 1), "there is no agent 7", CLQ_STALE_ID);
    expect_refused(set(agent_, "open", 0.5), "the variable 'open' is true or false: 0 or 1 is wanted, not 0.5");
    for (const double value : {0.0, 1.0}) EXPECT_EQ(set(agent_, "open", value), CLQ_OK) << clq_last_error();
    EXPECT_EQ(set(agent_, "n", 0.5), CLQ_OK) << clq_last_error();
    EXPECT_EQ(set({}, "mood", 3), CLQ_OK) << clq_last_error();
    world_.step(1);
    EXPECT_EQ(world_.variable(agent_, "n"), 0.5);
    EXPECT_EQ(world_.crowd_variable("mood"), 3);
    double value = 0;
    expect_refused(clq_stage_get_variable(stage_, agent_, "mood", &value), "there is no variable 'mood'");
    expect_refused(clq_stage_get_variable(stage_, {}, "n", &value), "there is no variable 'n'");
    expect_refused(clq_stage_get_variable(stage_, {7}, "n", &value), "there is no agent 7", CLQ_STALE_ID);
}

// Variables of an agent that has not begun are those that its machine begins with.
TEST_F(StageMessages, VariablesBeforeTheFirstStateAreThoseOfTheMachine)
{
    const clq_machine machine =
        world_.machine("machine = \"late\"\n[variables]\nn = 4.0\n[states.a]\ninitial = true\n");
    clq_agent_def def = clq_agent_def_init();
    def.machine = machine, def.tmpl = world_.arm.tmpl, def.start_s = 100;
    clq_agent late{};
    ASSERT_EQ(clq_stage_add_agent(stage_, &def, &late), CLQ_OK) << clq_last_error();
    EXPECT_EQ(world_.variable(late, "n"), 4);
    EXPECT_EQ(world_.state(late), "");
    EXPECT_EQ(world_.entered_s(late), 0);
}

TEST_F(StageMessages, TimetablesThatCannotBeAreRefusedByLineAndColumn)
{
    const auto wrong = [&](const std::string &text, const char *place, const char *rule,
                           clq_status status = CLQ_FORMAT) {
        clq_stage_text source = clq_stage_text_init();
        source.text = text.data(), source.text_bytes = text.size(), source.name = "t.toml";
        expect_refused(clq_stage_add_timetable(stage_, &source, 0), place, status);
        expect_refused(clq_stage_add_timetable(stage_, &source, 0), rule, status);
    };
    const std::string event = "[[event]]\nat = 1\nsend = \"go\"\n";
    wrong("[[events]]\n", "t.toml, line 1", "'events' is not known here: 'event' is near");
    wrong("event = 3\n", "t.toml, line 1, column 9", "'event' is not a list");
    wrong(event + "value = nan\n", "line 4, column 9", "'value' is not finite");
    wrong("event = [3]\n", "t.toml, line 1, column 10", "an event is not a table");
    wrong("[[event]]\nat = 1\n", "line 1, column 1", "an event needs 'at' and 'send'");
    wrong("[[event]]\nat = 1\nsend = 3\n", "line 3, column 8", "'send' is not a string");
    wrong("[[event]]\nat = 1e10\nsend = \"go\"\n", "line 2, column 6", "'at' is 1e+10: -1e+09 to 1e+09 is wanted");
    wrong(event + "when = 3\n", "line 4, column 1", "'when' is not known here");
    wrong(event + "value = \"much\"\n", "line 4, column 9", "'value' is not a number");
    wrong(event + "radius = -1\n", "line 4, column 10", "'radius' is -1");
    wrong(event + "per_m = 2e6\n", "line 4, column 9", "'per_m' is 2e+06");
    wrong(event + "class = 4\n", "line 4, column 9", "'class' is not a string");
    wrong(event + "position = [1, 2]\n", "line 4, column 12", "'position' has 2 numbers: x, y, z is wanted");
    wrong(event + "every = 0.001\n", "line 4, column 9", "'every' is 0.001");
    wrong(event + "times = 2\n", "line 4, column 9", "'times' belongs to 'every'");
    wrong(event + "every = 1\ntimes = 0\n", "line 5, column 9", "'times' is 0");
    wrong(event + "every = 1\ntimes = 1.5\n", "line 5, column 9", "'times' is 1.5: a whole number is wanted");
    const std::string large((4u << 20) + 1, ' ');
    wrong(large, "t.toml has 4194305 bytes", "4194304 are the most", CLQ_LIMIT);
    world_.step(3);
    EXPECT_EQ(world_.info().events, 0u);
}

}  // namespace
