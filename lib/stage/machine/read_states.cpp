#include "lib/base/near_names.h"
#include "lib/stage/error.h"
#include "lib/stage/machine/reader.h"

namespace claque::stage
{

void MachineReader::declare_states(const toml::node &from, uint32_t parent)
{
    const toml::table &all = doc_.table(from, "'states'");
    if (all.empty()) doc_.refuse(from, "'states' holds no state");
    for (const auto &[key, node] : doc_.in_order(all)) declare_state(*key, *node, parent);
    const uint32_t initial = initial_of(parent, from);
    if (parent == none) out_.initial = initial;
    else out_.states[parent].initial = initial;
}

void MachineReader::declare_state(const toml::key &key, const toml::node &from, uint32_t parent)
{
    const std::string name(key.str());
    const toml::table &table = doc_.table(from, "state '" + name + "'");
    doc_.known(table, {"initial", "enter", "leave", "while", "transitions", "states", "cost", "check"});
    const auto state = static_cast<uint32_t>(out_.states.size());
    const auto [other, is_new] = states_.emplace(name, state);
    if (!is_new)
        doc_.refuse(key.source(), text_of("two states are called '%s': the other is in line %u", name.c_str(),
                                          out_.states[other->second].line));
    if (state >= max_states) doc_.refuse(key.source(), text_of("more than %u states", max_states));
    State made;
    made.name = name;
    made.parent = parent;
    made.depth = parent == none ? 1 : out_.states[parent].depth + 1;
    made.line = static_cast<uint32_t>(key.source().begin.line);
    if (made.depth > max_depth) doc_.refuse(key.source(), text_of("more than %u states inside each other", max_depth));
    out_.states.push_back(std::move(made));
    state_nodes.push_back(&from);
    if (const toml::node *inner = table.get("states")) declare_states(*inner, state);
}

uint32_t MachineReader::initial_of(uint32_t parent, const toml::node &from) const
{
    uint32_t found = none, children = 0, only = none;
    for (uint32_t i = 0; i < out_.states.size(); ++i) {
        if (out_.states[i].parent != parent) continue;
        ++children;
        only = i;
        const toml::node *initial = state_nodes[i]->as_table()->get("initial");
        if (!initial || !doc_.truth(*initial, "initial")) continue;
        if (found != none)
            doc_.refuse(*initial, "two initial states beside each other: '" + out_.states[found].name + "' and '" +
                                      out_.states[i].name + "'");
        found = i;
    }
    if (found != none || children == 1) return found != none ? found : only;
    const std::string where = parent == none ? "the machine" : "state '" + out_.states[parent].name + "'";
    doc_.refuse(parent == none ? from : *state_nodes[parent],
                where + " has no initial state among its " + std::to_string(children));
}

uint32_t MachineReader::state_named(const std::string &name, const toml::node &at) const
{
    const auto found = states_.find(name);
    if (found == states_.end()) {
        std::vector<std::string_view> names;
        for (const State &one : out_.states) names.emplace_back(one.name);
        doc_.refuse(at, "there is no state '" + name + "'" + base::names_near(name, names));
    }
    return found->second;
}

void MachineReader::read_state(uint32_t state)
{
    const toml::table &from = *state_nodes[state]->as_table();
    if (const toml::node *cost = from.get("cost")) out_.states[state].cost = doc_.whole(*cost, "cost", 1, 1000000);
    out_.states[state].check_s = 0.5;
    if (const toml::node *check = from.get("check"))
        out_.states[state].check_s = doc_.number(*check, "check", 0.01, 1e6);
    if (const toml::node *enter = from.get("enter")) out_.states[state].enter = read_actions(*enter, "enter");
    if (const toml::node *leave = from.get("leave")) out_.states[state].leave = read_actions(*leave, "leave");
    if (const toml::node *repeated = from.get("while")) read_while(state, *repeated);
    const auto first = static_cast<uint32_t>(out_.transitions.size());
    if (const toml::node *transitions = from.get("transitions"))
        for (const toml::node &one : doc_.list(*transitions, "transitions")) read_transition(state, one);
    out_.states[state].transitions = {first, static_cast<uint32_t>(out_.transitions.size()) - first};
}

void MachineReader::read_while(uint32_t state, const toml::node &from)
{
    const toml::table &table = doc_.table(from, "'while'");
    doc_.known(table, {"every", "do"});
    if (!table.get("every") || !table.get("do")) doc_.refuse(from, "'while' needs 'every' and 'do'");
    out_.states[state].repeats = true;
    out_.states[state].repeat_every = quantity(table, "every", 0, 0.01, 1e6);
    out_.states[state].repeat = read_actions(*table.get("do"), "do");
}

void MachineReader::read_transition(uint32_t state, const toml::node &from)
{
    const toml::table &table = doc_.table(from, "a transition");
    doc_.known(table, {"on", "after", "end", "before", "marker", "if", "to", "weights", "history", "do"});
    if (out_.transitions.size() >= max_transitions)
        doc_.refuse(from, text_of("more than %u transitions", max_transitions));
    Transition made;
    made.source = state;
    made.line = static_cast<uint32_t>(from.source().begin.line);
    made.purpose = next_purpose();
    read_trigger(table, made);
    made.guard = guard(table);
    read_targets(table, made);
    if (const toml::node *actions = table.get("do")) made.actions = read_actions(*actions, "do");
    if (!made.targets.count && !made.actions.count) doc_.refuse(from, "the transition has neither 'to' nor 'do'");
    if (made.trigger == Trigger::instant) note_reads(out_.states[state], made);
    out_.transitions.push_back(made);
    transition_nodes.push_back(&from);
}

void MachineReader::read_trigger(const toml::table &from, Transition &made)
{
    const char *found = nullptr;
    for (const char *key : {"on", "after", "end", "marker"}) {
        const toml::node *node = from.get(key);
        if (!node) continue;
        if (found)
            doc_.refuse(*node, std::string("a transition has one of on, after, end and marker: this one has '") +
                                   found + "' and '" + key + "'");
        found = key;
    }
    if (const toml::node *before = from.get("before"); before && !from.get("end"))
        doc_.refuse(*before, "'before' belongs to 'end'");
    if (const toml::node *on = from.get("on")) {
        made.trigger = Trigger::event;
        made.event = event_named(*on, "on");
    } else if (from.get("after")) {
        made.trigger = Trigger::after;
        made.delay = quantity(from, "after", 0, 0, 1e9);
    } else if (const toml::node *end = from.get("end")) {
        if (!doc_.truth(*end, "end")) doc_.refuse(*end, "'end' is true, or is left out");
        made.trigger = Trigger::clip_end;
        made.delay = quantity(from, "before", 0, 0, 1e6);
    } else if (const toml::node *marker = from.get("marker")) {
        made.trigger = Trigger::marker;
        made.marker =
            number_of(out_.marker_names, marker_nodes, doc_.string(*marker, "marker"), *marker, max_events, "markers");
    }
}

void MachineReader::read_targets(const toml::table &from, Transition &made)
{
    const toml::node *to = from.get("to"), *weights = from.get("weights"), *history = from.get("history");
    if (!to && weights) doc_.refuse(*weights, "'weights' belongs to 'to'");
    if (!to && history) doc_.refuse(*history, "'history' belongs to 'to'");
    if (!to) return;
    made.targets.first = static_cast<uint32_t>(out_.targets.size());
    for (const auto &[name, node] : doc_.strings(*to, "to")) out_.targets.push_back({state_named(name, *node), 1});
    made.targets.count = static_cast<uint32_t>(out_.targets.size()) - made.targets.first;
    if (weights) {
        const toml::array &all = doc_.list(*weights, "weights");
        if (all.size() != made.targets.count)
            doc_.refuse(*weights, text_of("%zu weights for %u states", all.size(), made.targets.count));
        double total = 0;
        for (uint32_t i = 0; i < made.targets.count; ++i)
            total += out_.targets[made.targets.first + i].weight = doc_.number(all[i], "weights", 0, 1e9);
        if (!(total > 0)) doc_.refuse(*weights, "all weights are 0");
    }
    if (!history) return;
    const std::string word = doc_.string(*history, "history");
    if (word != "shallow" && word != "deep") doc_.refuse(*history, "'history' is shallow or deep, not '" + word + "'");
    made.history = word == "deep" ? History::deep : History::shallow;
    for (uint32_t i = 0; i < made.targets.count; ++i) {
        const State &target = out_.states[out_.targets[made.targets.first + i].state];
        if (target.initial == none) doc_.refuse(*history, "'" + target.name + "' has no states within, so no history");
    }
}

// What makes a condition change without a task of the agent itself.
void MachineReader::note_reads(State &state, const Transition &transition)
{
    for (uint32_t i = 0; i < transition.guard.count; ++i) {
        const Op &op = out_.ops[transition.guard.first + i];
        if (op.code == Code::crowd) state.crowd_reads |= uint64_t(1) << op.index;
        if (op.code == Code::time || op.code == Code::clock || op.code == Code::near || op.code == Code::count ||
            op.code == Code::random)
            state.checks = true;
    }
}

}  // namespace claque::stage
