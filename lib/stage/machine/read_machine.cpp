#include <claque/template_info.h>

#include <algorithm>

#include "lib/base/near_names.h"
#include "lib/stage/error.h"
#include "lib/stage/hash.h"
#include "lib/stage/machine/cast.h"
#include "lib/stage/machine/reader.h"

namespace claque::stage
{

uint32_t Vocabulary::find_event(std::string_view event) const
{
    for (size_t i = 0; i < events.size(); ++i)
        if (events[i].name == event) return static_cast<uint32_t>(i);
    return none;
}

uint32_t Vocabulary::find_class(std::string_view agent_class) const
{
    for (size_t i = 0; i < classes.size(); ++i)
        if (classes[i] == agent_class) return static_cast<uint32_t>(i);
    return none;
}

uint32_t Vocabulary::add_class(std::string_view agent_class)
{
    const uint32_t found = find_class(agent_class);
    if (found != none) return found;
    classes.emplace_back(agent_class);
    return static_cast<uint32_t>(classes.size() - 1);
}

void MachineReader::read()
{
    const toml::table &all = doc_.root();
    doc_.known(all, {"machine", "cost", "variables", "crowd", "events", "masks", "places", "states"});
    const toml::node *name = all.get("machine");
    if (!name) doc_.refuse(all, "it has no name: machine = \"...\"");
    out_.name = doc_.string(*name, "machine");
    read_names();
    const toml::node *states = all.get("states");
    if (!states) doc_.refuse(all, "it has no [states]");
    declare_states(*states, none);
    for (uint32_t i = 0; i < out_.states.size(); ++i) read_state(i);
    const toml::node *cost = all.get("cost");
    const uint32_t machine_cost = cost ? doc_.whole(*cost, "cost", 1, 1000000) : 1;
    for (State &state : out_.states)
        if (state.cost == 0) state.cost = state.parent == none ? machine_cost : out_.states[state.parent].cost;
    check_machine(doc_, out_, state_nodes, transition_nodes);
}

void MachineReader::read_names()
{
    const toml::table &all = doc_.root();
    if (const toml::node *variables = all.get("variables"))
        read_variables(doc_.table(*variables, "'variables'"), out_.variables, max_variables, "variables");
    if (const toml::node *crowd = all.get("crowd")) read_crowd(doc_.table(*crowd, "'crowd'"));
    if (const toml::node *events = all.get("events")) read_events(doc_.table(*events, "'events'"));
    if (const toml::node *masks = all.get("masks")) read_masks(doc_.table(*masks, "'masks'"));
    if (const toml::node *places = all.get("places"))
        for (const auto &[key, node] : doc_.in_order(doc_.table(*places, "'places'"))) {
            double point[3];
            doc_.point(*node, std::string(key->str()), point);
            places_.emplace(std::string(key->str()), node);
        }
}

void MachineReader::read_variables(const toml::table &from, std::vector<Variable> &out, uint32_t most, const char *what)
{
    for (const auto &[key, node] : doc_.in_order(from)) {
        Variable made;
        made.name = std::string(key->str());
        if (made.name.find_first_not_of("abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_") !=
                std::string::npos ||
            made.name.empty() || (made.name[0] >= '0' && made.name[0] <= '9'))
            doc_.refuse(key->source(), "'" + made.name + "' is no name: letters, digits and _ are wanted");
        for (const char *taken : {"time", "clock", "value", "distance", "in_view", "walking", "own_speed", "true",
                                  "false", "and", "or", "not", "min", "max", "abs", "floor", "random", "near", "count"})
            if (made.name == taken) doc_.refuse(key->source(), "'" + made.name + "' has a meaning of its own");
        made.type = node->is_boolean() ? Type::truth : Type::number;
        made.initial = node->is_boolean() ? double(doc_.truth(*node, made.name)) : doc_.number(*node, made.name);
        if (out.size() >= most) doc_.refuse(key->source(), text_of("more than %u %s", most, what));
        out.push_back(std::move(made));
    }
}

void MachineReader::read_crowd(const toml::table &from)
{
    std::vector<Variable> own;
    read_variables(from, own, max_variables, "variables of the crowd");
    const auto keys = doc_.in_order(from);
    for (size_t i = 0; i < own.size(); ++i) {
        const auto same = std::find_if(shared_.crowd.begin(), shared_.crowd.end(),
                                       [&](const Variable &other) { return other.name == own[i].name; });
        own_crowd_.push_back(static_cast<uint32_t>(same - shared_.crowd.begin()));
        if (same == shared_.crowd.end()) {
            if (shared_.crowd.size() >= max_variables)
                doc_.refuse(keys[i].first->source(), text_of("more than %u variables of the crowd", max_variables));
            shared_.crowd.push_back(own[i]);
        } else if (same->type != own[i].type || same->initial != own[i].initial) {
            doc_.refuse(*keys[i].second, text_of("another machine declares crowd.%s with the default %g",
                                                 own[i].name.c_str(), same->initial));
        }
    }
}

void MachineReader::read_events(const toml::table &from)
{
    for (const auto &[key, node] : doc_.in_order(from)) {
        Event made;
        made.name = std::string(key->str());
        made.priority = static_cast<uint8_t>(doc_.whole(*node, made.name, 0, 3));
        const uint32_t same = shared_.find_event(made.name);
        if (same != none && same < built_in_events)
            doc_.refuse(key->source(), "'" + made.name + "' is an event of the stage itself");
        if (same != none && shared_.events[same].priority != made.priority)
            doc_.refuse(*node, text_of("another machine gives '%s' the priority class %u", made.name.c_str(),
                                       unsigned(shared_.events[same].priority)));
        if (same != none) continue;
        if (shared_.events.size() >= max_events) doc_.refuse(key->source(), text_of("more than %u events", max_events));
        shared_.events.push_back(std::move(made));
    }
}

void MachineReader::read_masks(const toml::table &from)
{
    for (const auto &[key, node] : doc_.in_order(from)) {
        const toml::table &mask = doc_.table(*node, "mask '" + std::string(key->str()) + "'");
        doc_.known(mask, {"nodes", "feather", "inverted"});
        Mask made;
        made.name = std::string(key->str());
        const toml::node *nodes = mask.get("nodes");
        if (!nodes) doc_.refuse(mask, "it lacks 'nodes'");
        std::vector<const toml::node *> &places = mask_nodes.emplace_back();
        for (auto &[name, at] : doc_.strings(*nodes, "nodes")) {
            made.nodes.push_back(std::move(name));
            places.push_back(at);
        }
        if (const toml::node *feather = mask.get("feather")) made.feather = doc_.whole(*feather, "feather", 0, 1000);
        if (const toml::node *inverted = mask.get("inverted")) made.inverted = doc_.truth(*inverted, "inverted");
        out_.masks.push_back(std::move(made));
    }
}

Names::Found MachineReader::variable(std::string_view name) const
{
    for (size_t i = 0; i < out_.variables.size(); ++i)
        if (out_.variables[i].name == name) return {static_cast<uint32_t>(i), out_.variables[i].type};
    return {};
}

Names::Found MachineReader::crowd_variable(std::string_view name) const
{
    for (const uint32_t i : own_crowd_)
        if (shared_.crowd[i].name == name) return {i, shared_.crowd[i].type};
    return {};
}

std::string MachineReader::near(std::string_view name) const
{
    std::vector<std::string> all;
    for (const Variable &one : out_.variables) all.push_back(one.name);
    for (const uint32_t i : own_crowd_) all.push_back("crowd." + shared_.crowd[i].name);
    all.insert(all.end(), {"time", "clock", "value", "distance", "in_view", "walking", "own_speed"});
    return base::names_near(name, all);
}

std::unique_ptr<Machine> read_machine(std::string_view text, const std::string &name, const std::vector<CastDef> &casts,
                                      Vocabulary &shared)
{
    const Document document(text, name);
    auto made = std::make_unique<Machine>();
    MachineReader reader(document, *made, shared);
    reader.read();
    uint64_t h = start_of_sum;
    for (const char c : text) h = (h ^ static_cast<unsigned char>(c)) * 0x100000001b3ULL;
    for (const CastDef &def : casts) {
        made->casts.push_back(find_parts(def, *made, document, reader));
        for (const double duration_s : made->casts.back().durations_s) h = sum(h, duration_s);
    }
    made->hash = h;
    return made;
}

}  // namespace claque::stage
