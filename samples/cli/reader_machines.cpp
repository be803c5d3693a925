// State machines for `claque bench readers`.
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

Reading read_machine(scenes::Library &library, const std::string &bytes)
{
    const Own<clq_template> tmpl = template_of(library, gltf_with_animations(1));
    const clq_template *const templates[] = {tmpl.get()};
    clq_stage *stage = nullptr;
    scenes::check(clq_stage_create(library.context(), nullptr, &stage));
    clq_machine_def def = clq_machine_def_init();
    def.template_count = 1, def.templates = templates;
    def.source.text = bytes.data(), def.source.text_bytes = bytes.size(), def.source.name = "machine";
    const Reading out = timed([&] {
        clq_machine made;
        return outcome_of(clq_stage_add_machine(stage, &def, &made));
    });
    clq_stage_destroy(stage);
    return out;
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
            {"machine", "lines of comment", most_elements, comments, read_machine}};
}

}  // namespace cli
