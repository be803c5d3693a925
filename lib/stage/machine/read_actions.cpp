#include <algorithm>
#include <iterator>

#include "lib/base/near_names.h"
#include "lib/stage/error.h"
#include "lib/stage/machine/reader.h"

namespace claque::stage
{

Range MachineReader::read_actions(const toml::node &from, const std::string &what)
{
    std::vector<Action> made;  // in one piece, though actions of one list never hold others
    for (const toml::node &one : doc_.list(from, what)) {
        made.emplace_back();
        read_action(doc_.table(one, "an action"), made.back());
    }
    if (out_.actions.size() + made.size() > max_actions)
        doc_.refuse(from, text_of("more than %u actions", max_actions));
    const Range range{static_cast<uint32_t>(out_.actions.size()), static_cast<uint32_t>(made.size())};
    out_.actions.insert(out_.actions.end(), made.begin(), made.end());
    return range;
}

void MachineReader::read_action(const toml::table &from, Action &made)
{
    using Read = void (MachineReader::*)(const toml::table &, Action &);
    static constexpr struct {
        const char *key;
        Verb verb;
        Read read;
    } all[] = {{"play", Verb::play, &MachineReader::read_play},
               {"gesture", Verb::gesture, &MachineReader::read_gesture},
               {"end_gesture", Verb::end_gesture, nullptr},
               {"walk_on", Verb::walk_on, nullptr},
               {"set", Verb::set, &MachineReader::read_set},
               {"send", Verb::send, &MachineReader::read_send},
               {"look", Verb::look, &MachineReader::read_look},
               {"go", Verb::go, &MachineReader::read_go},
               {"stop", Verb::stop, nullptr},
               {"call", Verb::call, &MachineReader::read_call}};
    uint32_t found = none;
    for (uint32_t i = 0; i < std::size(all); ++i) {
        const toml::node *node = from.get(all[i].key);
        if (node && found != none)
            doc_.refuse(*node, std::string("an action does one thing: this one has '") + all[found].key + "' and '" +
                                   all[i].key + "'");
        if (node) found = i;
    }
    if (found == none)
        doc_.refuse(from,
                    "an action has one of play, gesture, end_gesture, walk_on, set, send, look, go, stop and call");
    made.purpose = next_purpose();
    made.guard = guard(from);
    made.verb = all[found].verb;
    if (all[found].read) return (this->*all[found].read)(from, made);
    const char *key = all[found].key;
    if (made.verb == Verb::stop) doc_.known(from, {"stop", "if"});
    else doc_.known(from, {key, "fade", "if"});
    if (!doc_.truth(*from.get(key), key))
        doc_.refuse(*from.get(key), std::string("'") + key + "' is true, or is left out");
    made.fade = quantity(from, "fade", made.verb == Verb::walk_on ? 0.3 : 0.2, 0, 3600);
    out_.goes |= made.verb != Verb::end_gesture;
}

uint32_t MachineReader::number_of(std::vector<std::string> &names, std::vector<const toml::node *> &nodes,
                                  const std::string &name, const toml::node &at, uint32_t most, const char *what)
{
    const auto found = std::find(names.begin(), names.end(), name);
    if (found != names.end()) return static_cast<uint32_t>(found - names.begin());
    if (names.size() >= most) doc_.refuse(at, text_of("more than %u %s", most, what));
    names.push_back(name);
    nodes.push_back(&at);
    return static_cast<uint32_t>(names.size() - 1);
}

Range MachineReader::read_clips(const toml::node &from, const std::string &what)
{
    const auto first = static_cast<uint32_t>(out_.clip_choices.size());
    for (const auto &[name, node] : doc_.strings(from, what))
        out_.clip_choices.push_back(number_of(out_.clip_names, clip_nodes, name, *node, max_clips, "clips"));
    return {first, static_cast<uint32_t>(out_.clip_choices.size()) - first};
}

void MachineReader::read_play(const toml::table &from, Action &made)
{
    doc_.known(from, {"play", "fade", "speed", "phase", "curve", "if"});
    made.clips = read_clips(*from.get("play"), "play");
    made.fade = quantity(from, "fade", 0.3, 0, 3600);
    made.speed = quantity(from, "speed", 1, 0.01, 100);
    made.phase = quantity(from, "phase", 0, 0, 1);
    const toml::node *curve = from.get("curve");
    if (!curve) return;
    const std::string word = doc_.string(*curve, "curve");
    if (word != "linear" && word != "smooth" && word != "inertial")
        doc_.refuse(*curve, "'curve' is linear, smooth or inertial, not '" + word + "'");
    made.curve = word == "linear" ? CLQ_CURVE_LINEAR : word == "smooth" ? CLQ_CURVE_SMOOTH : CLQ_CURVE_INERTIAL;
}

void MachineReader::read_gesture(const toml::table &from, Action &made)
{
    doc_.known(from, {"gesture", "loops", "weight", "speed", "fade_in", "fade_out", "add", "mask", "if"});
    made.clips = read_clips(*from.get("gesture"), "gesture");
    if (const toml::node *add = from.get("add")) made.adds = doc_.truth(*add, "add");
    made.loops = quantity(from, "loops", 1, 0, 1e6);
    made.weight = quantity(from, "weight", 1, made.adds ? -4 : 0, made.adds ? 4 : 1);
    made.speed = quantity(from, "speed", 1, 0.01, 100);
    made.fade = quantity(from, "fade_in", 0.2, 0, 3600);
    made.fade_out = quantity(from, "fade_out", 0.2, 0, 3600);
    const toml::node *mask = from.get("mask");
    if (!mask) return;
    const std::string name = doc_.string(*mask, "mask");
    for (size_t i = 0; i < out_.masks.size(); ++i)
        if (out_.masks[i].name == name) made.mask = static_cast<uint32_t>(i);
    if (made.mask != none) return;
    std::vector<std::string_view> names;
    for (const auto &one : out_.masks) names.emplace_back(one.name);
    doc_.refuse(*mask, "there is no mask '" + name + "' in [masks]" + base::names_near(name, names));
}

void MachineReader::read_set(const toml::table &from, Action &made)
{
    doc_.known(from, {"set", "to", "if"});
    const toml::node &node = *from.get("set");
    const std::string name = doc_.string(node, "set");
    made.of_crowd = name.compare(0, 6, "crowd.") == 0;
    const Found found = made.of_crowd ? crowd_variable(name.substr(6)) : variable(name);
    if (found.index == none) doc_.refuse(node, "there is no variable '" + name + "' to set" + near(name));
    made.variable = found.index;
    const toml::node *to = from.get("to");
    if (!to) doc_.refuse(from, "'set' needs 'to'");
    made.program.first = static_cast<uint32_t>(out_.ops.size());
    if (to->is_boolean() || to->is_number()) {
        if (to->is_boolean() != (found.type == Type::truth))
            doc_.refuse(*to, "'" + name + "' is " + (found.type == Type::truth ? "true or false" : "a number"));
        out_.ops.push_back(
            {Code::number, 0, to->is_boolean() ? double(doc_.truth(*to, "to")) : doc_.number(*to, "to")});
        made.program.count = 1;
    } else {
        made.program = expression(*to, "to", found.type);
    }
}

uint32_t MachineReader::event_named(const toml::node &from, const std::string &what) const
{
    const std::string name = doc_.string(from, what);
    const uint32_t found = shared_.find_event(name);
    const toml::node *own = doc_.root().get("events");
    const bool declared = own && own->is_table() && own->as_table()->contains(name);
    if (found != none && (found < built_in_events || declared)) return found;
    std::vector<std::string_view> names;
    if (own && own->is_table())
        for (const auto &[key, node] : *own->as_table()) names.emplace_back(key.str());
    doc_.refuse(from, "there is no event '" + name + "' in [events]" + base::names_near(name, names));
}

void MachineReader::read_send(const toml::table &from, Action &made)
{
    doc_.known(from, {"send", "to", "class", "radius", "delay", "value", "per_m", "if"});
    made.variable = event_named(*from.get("send"), "send");
    if (const toml::node *to = from.get("to")) {
        const std::string word = doc_.string(*to, "to");
        if (word != "self" && word != "sender" && word != "all")
            doc_.refuse(*to, "'to' is self, sender or all, not '" + word + "'");
        made.to = word == "self" ? To::self : word == "sender" ? To::sender : To::all;
    }
    for (const char *key : {"class", "radius", "per_m"})
        if (const toml::node *node = from.get(key); node && made.to != To::all)
            doc_.refuse(*node, std::string("'") + key + "' chooses among all, and 'to' names one");
    if (const toml::node *of = from.get("class")) made.agent_class = shared_.add_class(doc_.string(*of, "class"));
    made.radius = quantity(from, "radius", 0, 0, 1e6);
    made.delay = quantity(from, "delay", 0, 0, 1e6);
    made.value = quantity(from, "value", 0, -1e300, 1e300);
    made.per_m = quantity(from, "per_m", 0, 0, 1e6);
}

void MachineReader::read_look(const toml::table &from, Action &made)
{
    doc_.known(from, {"look", "if"});
    const toml::node &node = *from.get("look");
    if (node.is_array()) return doc_.point(node, "look", made.point);
    const std::string word = doc_.string(node, "look");
    made.aim = word == "sender" ? Aim::sender : word == "none" ? Aim::nothing : Aim::agent_class;
    if (made.aim == Aim::agent_class) made.agent_class = shared_.add_class(word);
}

void MachineReader::read_go(const toml::table &from, Action &made)
{
    doc_.known(from, {"go", "speed", "near", "heading", "settle", "if"});
    const toml::node &node = *from.get("go");
    made.speed = quantity(from, "speed", 0, 0.1, 12);
    if (!from.get("speed")) {
        made.speed.program = {static_cast<uint32_t>(out_.ops.size()), 1};
        made.speed.least = 0.1, made.speed.most = 12;
        out_.ops.push_back({Code::own_speed});
    }
    made.near_m = quantity(from, "near", 0.3, 0.01, 1000);
    made.has_heading = from.get("heading") != nullptr;
    if (made.has_heading) made.heading_deg = quantity(from, "heading", 0, -1e6, 1e6);
    if (const toml::node *settle = from.get("settle")) {
        made.settles = doc_.truth(*settle, "settle");
        if (made.settles && !made.has_heading) doc_.refuse(*settle, "'settle' needs 'heading'");
    }
    out_.goes = true;
    if (node.is_array()) return doc_.point(node, "go", made.point);
    const std::string word = doc_.string(node, "go");
    if (word == "sender") {
        made.aim = Aim::sender;
        return;
    }
    const auto place = places_.find(word);
    if (place == places_.end()) {
        std::vector<std::string_view> names;
        for (const auto &[one, at] : places_) names.emplace_back(one);
        doc_.refuse(node, "there is no place '" + word + "' in [places]" + base::names_near(word, names));
    }
    doc_.point(*place->second, word, made.point);
}

void MachineReader::read_call(const toml::table &from, Action &made)
{
    doc_.known(from, {"call", "value", "if"});
    const toml::node &node = *from.get("call");
    const std::string name = doc_.string(node, "call");
    const auto found = std::find(shared_.actions.begin(), shared_.actions.end(), name);
    if (found == shared_.actions.end())
        doc_.refuse(node, "there is no action '" + name + "' of the host (clq_stage_add_action)" +
                              base::names_near(name, shared_.actions));
    made.variable = static_cast<uint32_t>(found - shared_.actions.begin());
    made.value = quantity(from, "value", 0, -1e300, 1e300);
}

Quantity MachineReader::quantity(const toml::table &from, const char *key, double otherwise, double least, double most)
{
    Quantity made;
    made.purpose = next_purpose();
    made.least = made.most = otherwise;
    const toml::node *node = from.get(key);
    if (!node) return made;
    if (node->is_string()) {
        made.program = expression(*node, key, Type::number);
        made.least = least, made.most = most;
        return made;
    }
    if (!node->is_array()) {
        made.least = made.most = doc_.number(*node, key, least, most);
        return made;
    }
    const toml::array &pair = *node->as_array();
    if (pair.size() != 2) doc_.refuse(*node, std::string("'") + key + "' has not two numbers, [least, greatest]");
    made.least = doc_.number(pair[0], key, least, most);
    made.most = doc_.number(pair[1], key, least, most);
    if (made.least > made.most) doc_.refuse(*node, std::string("'") + key + "' has its greatest number first");
    return made;
}

Program MachineReader::expression(const toml::node &from, const std::string &what, Type wanted)
{
    const std::string text = doc_.string(from, what);
    const auto first = static_cast<uint32_t>(out_.ops.size());
    try {
        if (parse_expression(text, *this, out_.ops) != wanted)
            throw BadExpression{0, wanted == Type::truth ? "'" + what + "' is a number: a condition is wanted"
                                                         : "'" + what + "' is a condition: a number is wanted"};
    } catch (const BadExpression &bad) {
        doc_.refuse(from, bad.offset, bad.sentence);
    }
    return {first, static_cast<uint32_t>(out_.ops.size()) - first};
}

Program MachineReader::guard(const toml::table &from)
{
    const toml::node *node = from.get("if");
    return node ? expression(*node, "if", Type::truth) : Program();
}

}  // namespace claque::stage
