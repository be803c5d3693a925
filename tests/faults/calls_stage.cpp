// Calls for stages. Each is tried on a stage of its own, which a failed call must leave as it was; a step that fails
// goes on where it was.
#include <claque/stage.h>

#include "tests/api/failing_memory.h"
#include "tests/faults/calls.h"

namespace faults
{
namespace
{

using W = World &;

const char stage_text[] =
    "machine = \"m\"\n[variables]\nn = 0\nopen = false\n[crowd]\nmood = 0\n[events]\ngo = 0\ncome = 2\n"
    "[masks]\nm = { nodes = [\"tip\"] }\n[places]\np = [1, 2, 3]\n"
    "[states.a]\ninitial = true\nenter = [ { gesture = \"bend\" }, { play = \"bend\", fade = 0.2 }, { send = \"come\", "
    "radius = 9 } ]\n"
    "while = { every = 0.5, do = [ { set = \"crowd.mood\", to = \"crowd.mood + min(n, 1)\" } ] }\n"
    "transitions = [ { on = \"go\", to = [\"b\", \"c\"], weights = [1, 2] }, { end = true, before = 0.1, to = \"b\" },"
    " { if = \"crowd.mood > 3 and not open\", to = \"c\" } ]\n"
    "[states.a.states.x]\n[states.b]\ntransitions = [ { after = [1, 2], to = \"a\", history = \"deep\" } ]\n"
    "[states.c]\nenter = [ { call = \"ring\", value = \"n\" }, { go = \"p\" } ]\n"
    "transitions = [ { on = \"come\", to = \"a\" } ]\n";
const char times_text[] = "[[event]]\nat = 0.5\nsend = \"go\"\nclass = \"owl\"\nevery = 1\n";

void ring_bell(void *, const clq_action_call *) {}

int keep_stage(void *user, const void *bytes, size_t count)
{
    auto *all = static_cast<std::vector<unsigned char> *>(user);
    const auto *first = static_cast<const unsigned char *>(bytes);
    all->insert(all->end(), first, first + count);
    return 0;
}

int add_size(void *user, const void *, size_t count)
{
    *static_cast<size_t *>(user) += count;
    return 0;
}

std::vector<unsigned char> saved_stage(const clq_stage *stage)
{
    std::vector<unsigned char> bytes;
    EXPECT_EQ(clq_stage_save(stage, keep_stage, &bytes), CLQ_OK) << clq_last_error();
    return bytes;
}

clq_machine_def machine_def(W w)
{
    clq_machine_def def = clq_machine_def_init();
    def.source.text = stage_text, def.source.text_bytes = sizeof stage_text - 1;
    def.template_count = 1, def.templates = w.test.templates;
    return def;
}

clq_action_def action_def(const char *name)
{
    clq_action_def def = clq_action_def_init();
    def.name = name, def.decide = ring_bell, def.show = ring_bell;
    return def;
}

clq_agent_def agent_def(W w)
{
    clq_agent_def def = clq_agent_def_init();
    def.machine = {1}, def.tmpl = w.test.templates[0], def.agent_class = "owl", def.actor = w.objects.actor;
    return def;
}

// Some agents at work, in the middle of a run.
struct Playing {
    explicit Playing(W w)
    {
        EXPECT_EQ(clq_stage_create(w.test.context, nullptr, &stage), CLQ_OK) << clq_last_error();
        const clq_action_def action = action_def("ring");
        EXPECT_EQ(clq_stage_add_action(stage, &action), CLQ_OK) << clq_last_error();
        const clq_machine_def def = machine_def(w);
        clq_machine machine{};
        EXPECT_EQ(clq_stage_add_machine(stage, &def, &machine), CLQ_OK) << clq_last_error();
        clq_agent_def agent = agent_def(w);
        clq_agent made{};
        EXPECT_EQ(clq_stage_add_agent(stage, &agent, &made), CLQ_OK) << clq_last_error();
        agent.actor = {0, 0};
        for (int i = 0; i < 5; ++i) {
            agent.position[0] = i, agent.seed = uint64_t(i);
            EXPECT_EQ(clq_stage_add_agent(stage, &agent, &made), CLQ_OK) << clq_last_error();
        }
    }
    ~Playing() { clq_stage_destroy(stage); }
    Playing(const Playing &) = delete;
    Playing &operator=(const Playing &) = delete;
    clq_stage *stage = nullptr;
};

// A call on a stage; a failed one must have changed nothing.
template <class Body>
auto on_stage(const Body &body)
{
    return [body](W w) {
        std::vector<unsigned char> before, after;
        Playing *playing;
        {
            const failing_memory::Unarmed unarmed;
            playing = new Playing(w);
            before = saved_stage(playing->stage);
        }
        clq_status status = body(w, playing->stage);
        const failing_memory::Unarmed unarmed;
        after = saved_stage(playing->stage);
        if (status != CLQ_OK && after != before) status = clq_report(CLQ_CALLBACK, "the failed call changed the stage");
        w.found = hash_of(after.data(), after.size());
        delete playing;
        return status;
    };
}

clq_status stage_step(W w)
{
    Playing *playing;
    {
        const failing_memory::Unarmed unarmed;
        playing = new Playing(w);
    }
    const clq_status status = clq_stage_step(playing->stage, 3);
    const failing_memory::Unarmed unarmed;
    EXPECT_EQ(clq_stage_step(playing->stage, 3), CLQ_OK) << clq_last_error();
    const std::vector<unsigned char> bytes = saved_stage(playing->stage);
    w.found = hash_of(bytes.data(), bytes.size());
    static const uint64_t wanted = [&] {  // without a fault
        const Playing good(w);
        EXPECT_EQ(clq_stage_step(good.stage, 3), CLQ_OK) << clq_last_error();
        const std::vector<unsigned char> all = saved_stage(good.stage);
        return hash_of(all.data(), all.size());
    }();
    const bool same = w.found == wanted;
    delete playing;
    if (status != CLQ_OK) clq_report(status, "clq_stage_step: out of memory");
    return same ? status : clq_report(CLQ_CALLBACK, "the step that was repeated decided otherwise");
}

clq_status stage_apply(W w)
{
    Playing *playing;
    {
        const failing_memory::Unarmed unarmed;
        playing = new Playing(w);
        EXPECT_EQ(clq_stage_step(playing->stage, 0.1), CLQ_OK) << clq_last_error();
    }
    const clq_status status = clq_stage_apply(playing->stage, w.objects.crowd, 0.1, nullptr);
    const failing_memory::Unarmed unarmed;
    delete playing;
    return status;
}

clq_status stage_restore(W w)
{
    std::vector<unsigned char> bytes;
    {
        const failing_memory::Unarmed unarmed;
        const Playing other(w);
        EXPECT_EQ(clq_stage_step(other.stage, 2), CLQ_OK) << clq_last_error();
        bytes = saved_stage(other.stage);
    }
    return on_stage([&](W, clq_stage *stage) { return clq_stage_restore(stage, nullptr, bytes.data(), bytes.size()); })(
        w);
}

void add_getters(std::vector<Call> &all)
{
    all.push_back({"clq_stage_get_decided_s", on_stage([](W, clq_stage *stage) {
                       return clq_stage_get_decided_s(stage) == 0 ? CLQ_OK : CLQ_LIMIT;
                   }),
                   quiet});
    all.push_back({"clq_stage_get_info", on_stage([](W, clq_stage *stage) {
                       clq_stage_info info = clq_stage_info_init();
                       return clq_stage_get_info(stage, &info);
                   }),
                   quiet});
    all.push_back({"clq_stage_get_agent", on_stage([](W, clq_stage *stage) {
                       clq_agent_info info = clq_agent_info_init();
                       return clq_stage_get_agent(stage, {2}, &info);
                   }),
                   quiet});
    all.push_back({"clq_stage_get_variable", on_stage([](W, clq_stage *stage) {
                       double value;
                       return clq_stage_get_variable(stage, {}, "mood", &value);
                   }),
                   quiet});
    all.push_back({"clq_stage_destroy",
                   [](W) {
                       clq_stage_destroy(nullptr);
                       return CLQ_OK;
                   },
                   quiet});
}

void add_changes(std::vector<Call> &all)
{
    all.push_back({"clq_stage_add_action", on_stage([](W, clq_stage *stage) {
                       const clq_action_def def = action_def("a bell with a long enough name");
                       return clq_stage_add_action(stage, &def);
                   })});
    all.push_back({"clq_stage_add_machine", on_stage([](W w, clq_stage *stage) {
                       const clq_machine_def def = machine_def(w);
                       clq_machine made{};
                       return clq_stage_add_machine(stage, &def, &made);
                   })});
    all.push_back({"clq_stage_add_agent", on_stage([](W w, clq_stage *stage) {
                       clq_agent_def def = agent_def(w);
                       def.position[2] = 500;
                       def.agent_class = "a class with a long enough name";
                       clq_agent made{};
                       return clq_stage_add_agent(stage, &def, &made);
                   })});
    all.push_back({"clq_stage_remove_agent",
                   on_stage([](W, clq_stage *stage) { return clq_stage_remove_agent(stage, {3}); }), quiet});
    all.push_back({"clq_stage_set_place", on_stage([](W, clq_stage *stage) {
                       const double place[3] = {900, 0, 0};
                       return clq_stage_set_place(stage, {3}, place);
                   })});
    all.push_back({"clq_stage_send", on_stage([](W, clq_stage *stage) {
                       clq_stage_event event = clq_stage_event_init();
                       event.name = "go";
                       return clq_stage_send(stage, &event);
                   })});
    all.push_back({"clq_stage_set_variable",
                   on_stage([](W, clq_stage *stage) { return clq_stage_set_variable(stage, {2}, "n", 3, 1); })});
    all.push_back({"clq_stage_tell_view", on_stage([](W, clq_stage *stage) {
                       const clq_agent agents[2] = {{1}, {2}};
                       const bool in_view[2] = {true, false};
                       return clq_stage_tell_view(stage, agents, in_view, 2, 1);
                   })});
    all.push_back({"clq_stage_add_timetable", on_stage([](W, clq_stage *stage) {
                       clq_stage_text source = clq_stage_text_init();
                       source.text = times_text, source.text_bytes = sizeof times_text - 1;
                       return clq_stage_add_timetable(stage, &source, 1);
                   })});
}

}  // namespace

void add_stage_calls(std::vector<Call> &all)
{
    all.push_back({"clq_stage_create",
                   [](W w) { return clq_stage_create(w.test.context, nullptr, w.out<clq_stage>()); }, 0,
                   [](W w) { clq_stage_destroy(static_cast<clq_stage *>(w.made)); }});
    add_getters(all);
    add_changes(all);
    all.push_back({"clq_stage_step", stage_step});
    all.push_back({"clq_stage_apply", stage_apply, keeps});
    all.push_back({"clq_stage_save", on_stage([](W, clq_stage *stage) {
                       size_t size = 0;
                       return clq_stage_save(stage, add_size, &size);
                   })});
    all.push_back({"clq_stage_restore", stage_restore});
}

}  // namespace faults
