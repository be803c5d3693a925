// Decisions: 10 000 agents in nested states, of which 2000 take a transition in each step of 50 ms, on one core; and
// the drawing flow's share, which gives the commands to the crowd.
#include <claque/stage.h>

#include <algorithm>
#include <cstdlib>
#include <ctime>
#include <string>
#include <vector>

#include <benchmark/benchmark.h>

#include "tests/api/small_template.h"

namespace
{

// Each agent stays for a quarter of a second in a state, and leaves and enters two states then.
const char *const machine_text = R"toml(
machine = "m"
[variables]
n = 0.0
[events]
stop = 0
[states.one]
initial = true
leave = [ { set = "n", to = "n + 1" } ]
transitions = [ { on = "stop", to = "halted" } ]
[states.one.states.a]
initial = true
enter = [ { play = "bend", fade = 0.1, speed = [0.9, 1.1] } ]
transitions = [ { after = [0.2, 0.3], if = "n >= 0 and not walking", to = "b" } ]
[states.two]
transitions = [ { on = "stop", to = "halted" } ]
[states.two.states.b]
initial = true
enter = [ { play = "bend", fade = 0.1 } ]
transitions = [ { after = [0.2, 0.3], to = "one", history = "deep" } ]
[states.halted]
)toml";

void must(clq_status status)
{
    if (status != CLQ_OK) std::abort();
}

struct People {
    explicit People(uint32_t count)
    {
        must(clq_context_create(nullptr, &context));
        must(clq_template_build(context, &small.def, &tmpl));
        must(clq_crowd_create(context, nullptr, &crowd));
        must(clq_stage_create(context, nullptr, &stage));
        const clq_template *const templates[] = {tmpl};
        clq_machine_def machine = clq_machine_def_init();
        machine.source.text = machine_text, machine.source.text_bytes = std::string(machine_text).size();
        machine.template_count = 1, machine.templates = templates;
        clq_agent_def agent = clq_agent_def_init();
        must(clq_stage_add_machine(stage, &machine, &agent.machine));
        clq_actor_def actor = clq_actor_def_init();
        actor.tmpl = tmpl, agent.tmpl = tmpl;
        for (uint32_t i = 0; i < count; ++i) {
            agent.position[0] = i % 100, agent.position[2] = i / 100, agent.seed = i;
            agent.start_s = 0.25 * i / count;
            must(clq_actor_create(crowd, &actor, &agent.actor));
            clq_agent made;
            must(clq_stage_add_agent(stage, &agent, &made));
        }
        for (int warm = 0; warm < 100; ++warm) step();
    }
    ~People()
    {
        clq_stage_destroy(stage);
        clq_crowd_destroy(crowd);
        clq_template_destroy(tmpl);
        clq_context_destroy(context);
    }
    People(const People &) = delete;
    People &operator=(const People &) = delete;

    void step() { must(clq_stage_step(stage, 0.05 * ++steps)); }
    void apply() { must(clq_stage_apply(stage, crowd, 0.05 * steps, nullptr)); }
    uint64_t transitions() const
    {
        clq_stage_info info = clq_stage_info_init();
        must(clq_stage_get_info(stage, &info));
        return info.transitions;
    }

    SmallTemplate small;
    clq_context *context = nullptr;
    clq_template *tmpl = nullptr;
    clq_crowd *crowd = nullptr;
    clq_stage *stage = nullptr;
    int steps = 0;
};

double cpu_ms()
{
    timespec now;
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return 1e3 * double(now.tv_sec) + 1e-6 * double(now.tv_nsec);
}

void report(benchmark::State &state, std::vector<double> &ms, const char *minimum, const char *median)
{
    std::sort(ms.begin(), ms.end());
    state.counters[minimum] = ms.front();
    state.counters[median] = ms[ms.size() / 2];
}

void step(benchmark::State &state)
{
    People people(uint32_t(state.range(0)));
    std::vector<double> step_ms, apply_ms;
    const uint64_t before = people.transitions();
    for (auto _ : state) {
        const double start = cpu_ms();
        people.step();
        const double decided = cpu_ms();
        people.apply();
        step_ms.push_back(decided - start), apply_ms.push_back(cpu_ms() - decided);
    }
    state.counters["transitions/step"] = double(people.transitions() - before) / double(state.iterations());
    report(state, step_ms, "step_min_ms", "step_median_ms");
    report(state, apply_ms, "apply_min_ms", "apply_median_ms");
}

BENCHMARK(step)->Name("stage/step")->Arg(10000)->Unit(benchmark::kMillisecond)->Iterations(200);

}  // namespace
