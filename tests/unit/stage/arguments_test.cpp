// Calls of a stage with wrong arguments are refused with a sentence, and the stage stays as it is.
#include <cmath>
#include <filesystem>
#include <fstream>
#include <functional>
#include <sys/stat.h>
#include <unistd.h>

#include "tests/api/expect_refused.h"
#include "tests/unit/stage/stage_world.h"

namespace
{

class StageArguments : public testing::Test
{
protected:
    StageArguments()
    {
        machine_ = world_.machine(machine_text("[states.a]\ninitial = true\n"));
        agent_ = world_.agent(machine_);
        world_.step(0.1);
        transitions_ = world_.info().transitions;
    }
    ~StageArguments() override
    {
        world_.step(2);
        EXPECT_EQ(world_.info().agents, 1u);
        EXPECT_EQ(world_.info().machines, 1u);
        EXPECT_EQ(world_.info().events, 0u);
        EXPECT_EQ(world_.info().transitions, transitions_);
        EXPECT_EQ(world_.variable(agent_, "n"), 0);
    }

    StageWorld world_;
    clq_stage *stage_ = world_.stage;
    clq_machine machine_{};
    clq_agent agent_{};
    uint64_t transitions_ = 0;
};

TEST_F(StageArguments, NullPointersAreRefusedByEveryCall)
{
    clq_stage *made = nullptr;
    expect_refused(clq_stage_create(nullptr, nullptr, &made), "clq_stage_create: context or out is NULL");
    expect_refused(clq_stage_create(world_.arm.context, nullptr, nullptr), "clq_stage_create: context or out is NULL");
    EXPECT_EQ(made, nullptr);
    clq_stage_destroy(nullptr);
    expect_refused(clq_stage_step(nullptr, 1), "clq_stage_step: stage is NULL");
    EXPECT_EQ(clq_stage_get_decided_s(nullptr), 0);
    expect_refused(clq_stage_apply(nullptr, world_.arm.crowd, 0, nullptr), "clq_stage_apply: stage or crowd is NULL");
    expect_refused(clq_stage_apply(stage_, nullptr, 0, nullptr), "clq_stage_apply: stage or crowd is NULL");
    clq_stage_info info = clq_stage_info_init();
    expect_refused(clq_stage_get_info(nullptr, &info), "clq_stage_get_info: stage or out is NULL");
    expect_refused(clq_stage_get_info(stage_, nullptr), "clq_stage_get_info: stage or out is NULL");
    const clq_action_def action = clq_action_def_init();
    expect_refused(clq_stage_add_action(nullptr, &action), "clq_stage_add_action: stage or def is NULL");
    expect_refused(clq_stage_add_action(stage_, nullptr), "clq_stage_add_action: stage or def is NULL");
    const clq_machine_def machine = clq_machine_def_init();
    clq_machine machine_out{};
    expect_refused(clq_stage_add_machine(nullptr, &machine, &machine_out), "stage, def or out is NULL");
    expect_refused(clq_stage_add_machine(stage_, nullptr, &machine_out), "stage, def or out is NULL");
    expect_refused(clq_stage_add_machine(stage_, &machine, nullptr), "stage, def or out is NULL");
    const clq_agent_def agent = clq_agent_def_init();
    clq_agent agent_out{};
    expect_refused(clq_stage_add_agent(nullptr, &agent, &agent_out), "stage, def or out is NULL");
    expect_refused(clq_stage_add_agent(stage_, nullptr, &agent_out), "stage, def or out is NULL");
    expect_refused(clq_stage_add_agent(stage_, &agent, nullptr), "stage, def or out is NULL");
    expect_refused(clq_stage_remove_agent(nullptr, agent_), "clq_stage_remove_agent: stage is NULL");
    const double origin[3] = {0, 0, 0};
    expect_refused(clq_stage_set_place(nullptr, agent_, origin), "stage or position is NULL");
    expect_refused(clq_stage_set_place(stage_, agent_, nullptr), "stage or position is NULL");
    clq_agent_info found = clq_agent_info_init();
    expect_refused(clq_stage_get_agent(nullptr, agent_, &found), "stage or out is NULL");
    expect_refused(clq_stage_get_agent(stage_, agent_, nullptr), "stage or out is NULL");
    double value = 5;
    expect_refused(clq_stage_get_variable(nullptr, agent_, "n", &value), "stage, name or out is NULL");
    expect_refused(clq_stage_get_variable(stage_, agent_, nullptr, &value), "stage, name or out is NULL");
    expect_refused(clq_stage_get_variable(stage_, agent_, "n", nullptr), "stage, name or out is NULL");
    EXPECT_EQ(value, 5);
    const clq_stage_text text = clq_stage_text_init();
    expect_refused(clq_stage_add_timetable(nullptr, &text, 0), "stage or source is NULL");
    expect_refused(clq_stage_add_timetable(stage_, nullptr, 0), "stage or source is NULL");
    const clq_stage_event event = clq_stage_event_init();
    expect_refused(clq_stage_send(nullptr, &event), "stage or event is NULL");
    expect_refused(clq_stage_send(stage_, nullptr), "stage or event is NULL");
    expect_refused(clq_stage_set_variable(nullptr, agent_, "n", 0, 0), "stage or name is NULL");
    expect_refused(clq_stage_set_variable(stage_, agent_, nullptr, 0, 0), "stage or name is NULL");
    const bool seen = true;
    expect_refused(clq_stage_tell_view(nullptr, &agent_, &seen, 1, 0), "stage, agents or in_view is NULL");
    expect_refused(clq_stage_tell_view(stage_, nullptr, &seen, 1, 0), "stage, agents or in_view is NULL");
    expect_refused(clq_stage_tell_view(stage_, &agent_, nullptr, 1, 0), "stage, agents or in_view is NULL");
    EXPECT_EQ(clq_stage_tell_view(stage_, nullptr, nullptr, 0, 0), CLQ_OK);
    const auto write = [](void *, const void *, size_t) { return 0; };
    expect_refused(clq_stage_save(nullptr, write, nullptr), "stage or write is NULL");
    expect_refused(clq_stage_save(stage_, nullptr, nullptr), "stage or write is NULL");
    expect_refused(clq_stage_restore(nullptr, nullptr, "a", 1), "stage or bytes is NULL");
    expect_refused(clq_stage_restore(stage_, nullptr, nullptr, 1), "stage or bytes is NULL");
}

TEST_F(StageArguments, StructsOfAnotherHeaderAreRefused)
{
    const auto other = [&](auto made, const auto &call) {
        made.struct_bytes -= 4;
        expect_refused(call(&made), "struct_bytes is " + std::to_string(made.struct_bytes), CLQ_STRUCT_SIZE);
    };
    clq_stage *stage = nullptr;
    clq_machine machine{};
    clq_agent agent{};
    other(clq_stage_def_init(), [&](auto *def) { return clq_stage_create(world_.arm.context, def, &stage); });
    other(clq_stage_applied_init(), [&](auto *out) { return clq_stage_apply(stage_, world_.arm.crowd, 0, out); });
    other(clq_stage_info_init(), [&](auto *out) { return clq_stage_get_info(stage_, out); });
    other(clq_action_def_init(), [&](auto *def) { return clq_stage_add_action(stage_, def); });
    other(clq_machine_def_init(), [&](auto *def) { return clq_stage_add_machine(stage_, def, &machine); });
    other(clq_agent_def_init(), [&](auto *def) { return clq_stage_add_agent(stage_, def, &agent); });
    other(clq_agent_info_init(), [&](auto *out) { return clq_stage_get_agent(stage_, agent_, out); });
    other(clq_stage_event_init(), [&](auto *event) { return clq_stage_send(stage_, event); });
    EXPECT_EQ(stage, nullptr);
}

TEST_F(StageArguments, SettingsOutsideTheirLimitsAreRefused)
{
    const auto wrong = [&](const char *sentence, const std::function<void(clq_stage_def &)> &breaks) {
        clq_stage_def def = clq_stage_def_init();
        breaks(def);
        clq_stage *made = nullptr;
        expect_refused(clq_stage_create(world_.arm.context, &def, &made), sentence);
        EXPECT_EQ(made, nullptr);
    };
    using Def = clq_stage_def;
    wrong("mode is 2: 0 and 1 are known", [](Def &def) { def.mode = static_cast<clq_stage_mode>(2); });
    wrong("start_s is 1.1e+09: -1e9 to 1e9 is wanted", [](Def &def) { def.start_s = 1.1e9; });
    wrong("start_s is nan", [](Def &def) { def.start_s = NAN; });
    wrong("tick_s is 0.0009: 0.001 to 10 is wanted", [](Def &def) { def.tick_s = 0.0009; });
    wrong("tick_s is 10.5: 0.001 to 10 is wanted", [](Def &def) { def.tick_s = 10.5; });
    wrong("budget_us is -1: 0 or more is wanted", [](Def &def) { def.budget_us = -1; });
    wrong("budget_us is inf: 0 or more is wanted", [](Def &def) { def.budget_us = INFINITY; });
    wrong("a live budget of 5 microseconds needs the clock now_s",
          [](Def &def) { def.mode = CLQ_STAGE_LIVE, def.budget_us = 5; });
    wrong("shares[2] is 0: above 0 is wanted", [](Def &def) { def.shares[2] = 0; });
    wrong("the shares add up to 1.5, not to 1", [](Def &def) { def.shares[0] = 1; });
    wrong("metres_per_unit is 0: above 0 is wanted", [](Def &def) { def.metres_per_unit = 0; });
    wrong("metres_per_unit is inf: above 0 is wanted", [](Def &def) { def.metres_per_unit = INFINITY; });
}

TEST_F(StageArguments, TimesAndPlacesThatAreNoneAreRefused)
{
    expect_refused(clq_stage_step(stage_, NAN), "until_s is not finite");
    expect_refused(clq_stage_apply(stage_, world_.arm.crowd, INFINITY, nullptr), "time_s is not finite");
    expect_refused(clq_stage_apply(stage_, world_.arm.crowd, 0.2, nullptr),
                   "time_s is 0.2, and only what happens up to 0.1 is decided");
    expect_refused(clq_stage_set_variable(stage_, agent_, "n", INFINITY, 0), "value is not finite");
    expect_refused(clq_stage_set_variable(stage_, agent_, "n", 0, NAN), "at_s is not finite");
    const bool seen = true;
    expect_refused(clq_stage_tell_view(stage_, &agent_, &seen, 1, NAN), "at_s is not finite");
    clq_stage_text text = clq_stage_text_init();
    text.text = "", text.text_bytes = 0;
    expect_refused(clq_stage_add_timetable(stage_, &text, NAN), "offset_s is not finite");
    const double far[3] = {0, 0, 2e12}, nowhere[3] = {0, NAN, 0};
    expect_refused(clq_stage_set_place(stage_, agent_, far), "position[2] is 2e+12");
    expect_refused(clq_stage_set_place(stage_, agent_, nowhere), "position[1] is nan");
}

TEST_F(StageArguments, AgentsThatCannotBeAreRefused)
{
    const auto wrong = [&](const std::string &sentence, const std::function<void(clq_agent_def &)> &breaks) {
        clq_agent_def def = clq_agent_def_init();
        def.machine = machine_, def.tmpl = world_.arm.tmpl;
        breaks(def);
        clq_agent made{};
        expect_refused(clq_stage_add_agent(stage_, &def, &made), sentence);
        EXPECT_EQ(made.index1, 0u);
    };
    using Def = clq_agent_def;
    wrong("there is no machine 0", [](Def &def) { def.machine = {0}; });
    wrong("there is no machine 2", [](Def &def) { def.machine = {2}; });
    wrong("tmpl is none of the 1 templates of the machine 'm'", [](Def &def) { def.tmpl = nullptr; });
    wrong("position[0] is 1e+13", [](Def &def) { def.position[0] = 1e13; });
    wrong("heading_rad is not finite", [](Def &def) { def.heading_rad = NAN; });
    wrong("start_s is not finite", [](Def &def) { def.start_s = INFINITY; });
    for (const float scale : {0.0f, -1.0f, NAN, INFINITY})
        wrong("above 0 is wanted", [scale](Def &def) { def.scale = scale; });
    for (const clq_agent none : {clq_agent{0}, clq_agent{2}, clq_agent{0xffffffffu}}) {
        const std::string sentence = "there is no agent " + std::to_string(none.index1);
        clq_agent_info info = clq_agent_info_init();
        const double origin[3] = {0, 0, 0};
        const bool seen = true;
        expect_refused(clq_stage_get_agent(stage_, none, &info), sentence, CLQ_STALE_ID);
        expect_refused(clq_stage_remove_agent(stage_, none), sentence, CLQ_STALE_ID);
        expect_refused(clq_stage_set_place(stage_, none, origin), sentence, CLQ_STALE_ID);
        expect_refused(clq_stage_tell_view(stage_, &none, &seen, 1, 0), sentence, CLQ_STALE_ID);
    }
}

TEST_F(StageArguments, MachinesAndActionsWithoutTheirPartsAreRefused)
{
    const clq_template *const twice[2] = {world_.arm.tmpl, world_.arm.tmpl}, *const gap[2] = {world_.arm.tmpl, nullptr};
    const auto wrong = [&](const char *sentence, const std::function<void(clq_machine_def &)> &breaks,
                           clq_status status = CLQ_ARGUMENT) {
        clq_machine_def def = clq_machine_def_init();
        def.templates = twice, def.template_count = 1;
        breaks(def);
        clq_machine made{};
        expect_refused(clq_stage_add_machine(stage_, &def, &made), sentence, status);
        EXPECT_EQ(made.index1, 0u);
    };
    wrong("templates is NULL, or template_count is 0", [](clq_machine_def &def) { def.template_count = 0; });
    wrong("templates is NULL, or template_count is 0", [](clq_machine_def &def) { def.templates = nullptr; });
    wrong("templates 0 and 1 are the same", [](clq_machine_def &def) { def.template_count = 2; });
    wrong("template 1 is NULL", [&](clq_machine_def &def) { def.templates = gap, def.template_count = 2; });
    wrong("the text has neither a path nor bytes", [](clq_machine_def &def) { def.source.text_bytes = 1; });
    wrong(
        "/no/such.toml cannot be opened", [](clq_machine_def &def) { def.source.path = "/no/such.toml"; }, CLQ_IO);
    clq_action_def action = clq_action_def_init();
    expect_refused(clq_stage_add_action(stage_, &action), "decide and show are both NULL");
    action.show = [](void *, const clq_action_call *) {};
    expect_refused(clq_stage_add_action(stage_, &action), "the name is empty");
    action.name = "";
    expect_refused(clq_stage_add_action(stage_, &action), "the name is empty");
    action.name = "bow";
    EXPECT_EQ(clq_stage_add_action(stage_, &action), CLQ_OK) << clq_last_error();
    expect_refused(clq_stage_add_action(stage_, &action), "there is an action 'bow' already");
}

// A pipe without a writer would be waited for, and a device has no end.
TEST_F(StageArguments, NamesThatLeadToNoRegularFileOrToALongOneAreRefused)
{
    namespace fs = std::filesystem;
    const fs::path folder = fs::temp_directory_path() / ("claque-stage-" + std::to_string(getpid()));
    fs::create_directory(folder);
    const std::string pipe = folder / "pipe", large = folder / "large";
    EXPECT_EQ(mkfifo(pipe.c_str(), 0600), 0);
    std::ofstream(large).close();
    fs::resize_file(large, (4 << 20) + 1);
    for (const std::string &path : {std::string("/dev/zero"), std::string("/"), pipe, large}) {
        const bool is_regular = path == large;
        const std::string sentence = path + (is_regular ? " has more than 4194304 bytes" : " is not a regular file");
        clq_stage_text text = clq_stage_text_init();
        text.path = path.c_str();
        expect_refused(clq_stage_add_timetable(stage_, &text, 0), sentence, is_regular ? CLQ_LIMIT : CLQ_IO);
        clq_machine_def def = clq_machine_def_init();
        const clq_template *const one[1] = {world_.arm.tmpl};
        def.source.path = path.c_str(), def.templates = one, def.template_count = 1;
        clq_machine made{};
        expect_refused(clq_stage_add_machine(stage_, &def, &made), sentence, is_regular ? CLQ_LIMIT : CLQ_IO);
    }
    fs::remove_all(folder);
}

}  // namespace
