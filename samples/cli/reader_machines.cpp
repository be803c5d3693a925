// State machines, and saves of stages, for `claque bench readers`.
#include <claque/agents.h>
#include <claque/stage.h>

#include "samples/cli/reader_parts.h"

namespace cli
{
namespace machine_readers
{
namespace
{

using scenes::Own;

// `count` of what `one` says of each number, with commas between.
template <class One>
std::string list_of(uint32_t count, const One &one)
{
    return repeated(
        "[ ", count, [&](uint32_t i) { return (i ? ", " : "") + one(i); }, " ]");
}

const std::string head = "machine = \"m\"\n[events]\ngo = 0\n[variables]\nn = 0.0\n";

std::string one_state(const std::string &more) { return head + "[states.a]\n" + more + "\n"; }

std::string states(uint32_t count)
{
    return repeated(head, count, [=](uint32_t i) {
        return "[states.s" + digits(i) + "]\n" + (i ? "" : "initial = true\n") +
               "transitions = [ { on = \"go\", to = \"s" + digits((i + 1) % count) + "\" } ]\n";
    });
}

std::string transitions(uint32_t count)
{
    return one_state("transitions = " + list_of(count, [](uint32_t i) {
                         return "{ on = \"go\", if = \"n > " + digits(i) + "\", do = [ { set = \"n\", to = 1 } ] }";
                     }));
}

// Conditions alone, which might go round for ever.
std::string conditions(uint32_t count)
{
    return repeated(head, count, [=](uint32_t i) {
        return "[states.s" + digits(i) + "]\n" + (i ? "" : "initial = true\n") + "transitions = [ { if = \"n > " +
               digits(i) + "\", to = \"s" + digits((i + 1) % count) + "\", do = [ { set = \"n\", to = 0 } ] } ]\n";
    });
}

std::string targets(uint32_t count)
{
    return head + "[states.a]\ninitial = true\ntransitions = [ { on = \"go\", to = " +
           list_of(count, [](uint32_t) { return std::string("\"b\""); }) + " } ]\n[states.b]\n";
}

std::string actions(uint32_t count)
{
    return one_state("enter = " + list_of(count, [](uint32_t) { return std::string("{ set = \"n\", to = 1 }"); }));
}

std::string clips(uint32_t count)
{
    return one_state("enter = [ { play = " + list_of(count, [](uint32_t) { return std::string("\"clip 0\""); }) +
                     " } ]");
}

std::string terms(uint32_t count)
{
    const std::string sum = repeated("n", count - 1, [](uint32_t) { return std::string(" + n"); });
    return one_state("enter = [ { set = \"n\", to = \"" + sum + "\" } ]");
}

std::string variables(uint32_t count)
{
    return repeated(
        "machine = \"m\"\n[variables]\n", count, [](uint32_t i) { return "v" + digits(i) + " = 0.0\n"; },
        "[states.a]\n");
}

std::string events(uint32_t count)
{
    return repeated(
        "machine = \"m\"\n[events]\n", count, [](uint32_t i) { return "e" + digits(i) + " = 0\n"; }, "[states.a]\n");
}

std::string comments(uint32_t count)
{
    return repeated(one_state(""), count, [](uint32_t i) { return "# " + digits(i) + "\n"; });
}

// A stage for people of one template.
struct Stage {
    Own<clq_template> tmpl;
    clq_stage *stage = nullptr;

    explicit Stage(scenes::Library &library) : tmpl(template_of(library, gltf_with_animations(1)))
    {
        scenes::check(clq_stage_create(library.context(), nullptr, &stage));
    }
    ~Stage() { clq_stage_destroy(stage); }
    Stage(const Stage &) = delete;
    Stage &operator=(const Stage &) = delete;

    clq_status add(const std::string &text, clq_machine *made) const
    {
        const clq_template *const templates[] = {tmpl.get()};
        clq_machine_def def = clq_machine_def_init();
        def.template_count = 1, def.templates = templates;
        def.source.text = text.data(), def.source.text_bytes = text.size(), def.source.name = "machine";
        return clq_stage_add_machine(stage, &def, made);
    }
};

Reading read_machine(scenes::Library &library, const std::string &bytes)
{
    const Stage on(library);
    return timed([&] {
        clq_machine made;
        return outcome_of(on.add(bytes, &made));
    });
}

// Whose agents have a task each: to enter their first state.
std::string saved_agents(uint32_t count)
{
    scenes::Library library(1);
    const Stage on(library);
    clq_agent_def def = clq_agent_def_init();
    def.tmpl = on.tmpl.get();
    scenes::check(on.add(one_state(""), &def.machine));
    clq_agent made;
    for (uint32_t i = 0; i < count; ++i) scenes::check(clq_stage_add_agent(on.stage, &def, &made));
    std::string out;
    scenes::check(clq_stage_save(on.stage, append_bytes, &out));
    return out;
}

// To one agent.
std::string saved_messages(uint32_t count)
{
    scenes::Library library(1);
    const Stage on(library);
    clq_agent_def def = clq_agent_def_init();
    def.tmpl = on.tmpl.get();
    scenes::check(on.add(one_state(""), &def.machine));
    clq_stage_event event = clq_stage_event_init();
    event.name = "go";
    scenes::check(clq_stage_add_agent(on.stage, &def, &event.to));
    for (uint32_t i = 0; i < count; ++i) event.at_s = i, scenes::check(clq_stage_send(on.stage, &event));
    std::string out;
    scenes::check(clq_stage_save(on.stage, append_bytes, &out));
    return out;
}

Reading read_stage(scenes::Library &library, const std::string &bytes)
{
    const Stage on(library);
    clq_machine made;
    scenes::check(on.add(one_state(""), &made));
    return timed([&] { return outcome_of(clq_stage_restore(on.stage, nullptr, bytes.data(), bytes.size())); });
}

}  // namespace
}  // namespace machine_readers

std::vector<ReaderElement> reader_elements_of_machines()
{
    using namespace machine_readers;
    return {{"machine", "states", 1000, states, read_machine},
            {"machine", "transitions of a state", 4000, transitions, read_machine},
            {"machine", "transitions by condition", 1000, conditions, read_machine},
            {"machine", "targets of a transition", 4000, targets, read_machine},
            {"machine", "actions of a state", 8000, actions, read_machine},
            {"machine", "clips of an action", 4000, clips, read_machine},
            {"machine", "terms of an expression", 100, terms, read_machine},
            {"machine", "variables", 64, variables, read_machine},
            {"machine", "events", 240, events, read_machine},
            {"machine", "lines of comment", most_elements, comments, read_machine},
            {"stage", "agents", most_elements, saved_agents, read_stage},
            {"stage", "messages to one agent", most_elements, saved_messages, read_stage}};
}

}  // namespace cli
