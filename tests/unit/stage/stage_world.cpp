#include "tests/unit/stage/stage_world.h"

#include "tests/unit/stage/held_tasks.h"

std::string machine_text(const std::string &rest)
{
    return "machine = \"m\"\n[variables]\nn = 0.0\nlog = 0.0\nopen = false\n[crowd]\nmood = 0.0\n"
           "[events]\ngo = 0\nback = 1\nslow = 2\n" +
           rest;
}

StageWorld::StageWorld(const clq_stage_def *def)
{
    EXPECT_EQ(clq_stage_create(arm.context, def, &stage), CLQ_OK) << clq_last_error();
}

StageWorld::~StageWorld()
{
    expect_no_lost_task(stage);
    clq_stage_destroy(stage);
}

clq_machine StageWorld::machine(const std::string &text)
{
    clq_machine out{};
    EXPECT_EQ(refusal(text), "");
    clq_stage_info now = info();
    out.index1 = now.machines;
    return out;
}

std::string StageWorld::refusal(const std::string &text)
{
    clq_machine_def def = clq_machine_def_init();
    const clq_template *const templates[] = {arm.tmpl};
    def.template_count = 1, def.templates = templates;
    def.source.text = text.data(), def.source.text_bytes = text.size(), def.source.name = "m.toml";
    clq_machine out{};
    if (clq_stage_add_machine(stage, &def, &out) == CLQ_OK) return "";
    return clq_last_error();
}

clq_agent StageWorld::agent(clq_machine machine, double x, const char *agent_class, uint64_t seed)
{
    clq_agent_def def = clq_agent_def_init();
    def.machine = machine, def.tmpl = arm.tmpl, def.position[0] = x, def.agent_class = agent_class, def.seed = seed;
    def.start_s = clq_stage_get_decided_s(stage) + 1e-6;
    clq_agent out{};
    EXPECT_EQ(clq_stage_add_agent(stage, &def, &out), CLQ_OK) << clq_last_error();
    return out;
}

clq_agent StageWorld::actor_agent(clq_machine machine)
{
    clq_agent_def def = clq_agent_def_init();
    def.machine = machine, def.tmpl = arm.tmpl, def.actor = arm.actor, def.start_s = 1e-6;
    clq_agent out{};
    EXPECT_EQ(clq_stage_add_agent(stage, &def, &out), CLQ_OK) << clq_last_error();
    return out;
}

void StageWorld::step(double until_s) { EXPECT_EQ(clq_stage_step(stage, until_s), CLQ_OK) << clq_last_error(); }

clq_stage_applied StageWorld::apply(double time_s)
{
    clq_stage_applied out = clq_stage_applied_init();
    EXPECT_EQ(clq_stage_apply(stage, arm.crowd, time_s, &out), CLQ_OK) << clq_last_error();
    return out;
}

std::string StageWorld::state(clq_agent agent) const
{
    clq_agent_info out = clq_agent_info_init();
    EXPECT_EQ(clq_stage_get_agent(stage, agent, &out), CLQ_OK) << clq_last_error();
    return out.state ? out.state : "";
}

double StageWorld::entered_s(clq_agent agent) const
{
    clq_agent_info out = clq_agent_info_init();
    EXPECT_EQ(clq_stage_get_agent(stage, agent, &out), CLQ_OK) << clq_last_error();
    return out.entered_s;
}

double StageWorld::variable(clq_agent agent, const char *name) const
{
    double out = -1e9;
    EXPECT_EQ(clq_stage_get_variable(stage, agent, name, &out), CLQ_OK) << clq_last_error();
    return out;
}

void StageWorld::send(const char *name, double at_s, double value) { send_to({}, name, at_s, value); }

void StageWorld::send_to(clq_agent agent, const char *name, double at_s, double value)
{
    clq_stage_event event = clq_stage_event_init();
    event.name = name, event.at_s = at_s, event.value = value, event.to = agent;
    EXPECT_EQ(clq_stage_send(stage, &event), CLQ_OK) << clq_last_error();
}

clq_stage_info StageWorld::info() const
{
    clq_stage_info out = clq_stage_info_init();
    EXPECT_EQ(clq_stage_get_info(stage, &out), CLQ_OK) << clq_last_error();
    return out;
}
