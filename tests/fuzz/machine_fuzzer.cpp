// State machines and timetables of a stage: what is accepted runs for some seconds without harm.
#include <claque/stage.h>

#include "tests/api/small_template.h"
#include "tests/fuzz/fuzzer.h"

namespace
{

void ring(void *, const clq_action_call *) {}

struct FuzzedStage {
    FuzzedStage()
    {
        EXPECT_EQ(clq_context_create(nullptr, &context), CLQ_OK);
        EXPECT_EQ(clq_template_build(context, &small.def, &tmpl), CLQ_OK);
        EXPECT_EQ(clq_crowd_create(context, nullptr, &crowd), CLQ_OK);
        clq_actor_def def = clq_actor_def_init();
        def.tmpl = tmpl;
        EXPECT_EQ(clq_actor_create(crowd, &def, &actor), CLQ_OK);
    }
    // Once for all inputs.
    static FuzzedStage &one()
    {
        static FuzzedStage made;
        return made;
    }
    SmallTemplate small;
    clq_context *context = nullptr;
    clq_template *tmpl = nullptr;
    clq_crowd *crowd = nullptr;
    clq_actor actor{};
};

void play(clq_stage *stage, clq_machine machine)
{
    FuzzedStage &world = FuzzedStage::one();
    clq_agent_def agent = clq_agent_def_init();
    agent.machine = machine, agent.tmpl = world.tmpl, agent.actor = world.actor;
    for (int i = 0; i < 3; ++i) {
        clq_agent made{};
        EXPECT_EQ(clq_stage_add_agent(stage, &agent, &made), CLQ_OK) << clq_last_error();
        agent.actor = {0, 0}, agent.position[0] = i + 1, agent.agent_class = "owl";
    }
    EXPECT_EQ(clq_stage_step(stage, 2), CLQ_OK) << clq_last_error();
    EXPECT_EQ(clq_stage_apply(stage, world.crowd, 2, nullptr), CLQ_OK) << clq_last_error();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t size)
{
    FuzzedStage &world = FuzzedStage::one();
    clq_stage_def def = clq_stage_def_init();
    def.budget = 200;
    clq_stage *stage = nullptr;
    EXPECT_EQ(clq_stage_create(world.context, &def, &stage), CLQ_OK);
    clq_action_def action = clq_action_def_init();
    action.name = "ring", action.decide = ring;
    EXPECT_EQ(clq_stage_add_action(stage, &action), CLQ_OK);
    clq_machine_def machine = clq_machine_def_init();
    machine.source.text = reinterpret_cast<const char *>(bytes), machine.source.text_bytes = size;
    const clq_template *const templates[] = {world.tmpl};
    machine.template_count = 1, machine.templates = templates;
    clq_machine made{};
    const clq_status status = clq_stage_add_machine(stage, &machine, &made);
    EXPECT_TRUE(status == CLQ_OK || status == CLQ_FORMAT || status == CLQ_LIMIT) << clq_last_error();
    if (status == CLQ_OK) play(stage, made);
    const clq_status table = clq_stage_add_timetable(stage, &machine.source, 0);
    EXPECT_TRUE(table == CLQ_OK || table == CLQ_FORMAT || table == CLQ_LIMIT) << clq_last_error();
    clq_stage_destroy(stage);
    return 0;
}
