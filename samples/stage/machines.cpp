#include "samples/stage/machines.h"

#include <algorithm>
#include <cstdio>

#include "samples/io/files.h"
#include "samples/io/toml.h"
#include "samples/io/toml_keys.h"

namespace staged
{

using namespace scenes;

namespace
{

bool has_key(const toml::node &node, std::string_view key)
{
    if (const toml::table *table = node.as_table()) {
        for (const auto &[name, value] : *table)
            if (name.str() == key || has_key(value, key)) return true;
    } else if (const toml::array *list = node.as_array()) {
        for (const toml::node &value : *list)
            if (has_key(value, key)) return true;
    }
    return false;
}

// A section behind the last line, so that the lines before keep their numbers.
std::string section_of(const std::vector<Place> &places)
{
    if (places.empty()) return "";
    std::string text = "\n[places]\n";
    for (const Place &place : places) {
        std::string name;
        for (const char c : place.name) name += (c == '"' || c == '\\' ? "\\" : "") + std::string(1, c);
        char numbers[120];
        std::snprintf(numbers, sizeof numbers, "[%.17e, %.17e, %.17e]", place.position[0], place.position[1],
                      place.position[2]);
        text += "\"" + name + "\" = " + numbers + "\n";
    }
    return text;
}

// As they stand in the text.
void add_states(const toml::table &states, const std::string &within, std::vector<std::string> &out)
{
    std::vector<std::pair<uint32_t, std::string>> lines;
    for (const auto &[name, state] : states) lines.push_back({state.source().begin.line, std::string(name.str())});
    std::sort(lines.begin(), lines.end());
    for (const auto &[line, name] : lines) {
        out.push_back(within + name);
        const toml::table *own = states[name].as_table();
        const toml::table *inner = own ? (*own)["states"].as_table() : nullptr;
        if (inner) add_states(*inner, within + name + ".", out);
    }
}

// What the text says of the machine, and the places, unless it has its own. A text that cannot be read stays as it is:
// the stage says what is wrong with it.
void look_into(std::string &text, const std::vector<Place> &places, Machine &out)
{
    if (io::line_of_deep_key(text) != 0 || io::line_of_stray_letter(text) != 0) return;
    const toml::parse_result read = toml::parse(std::string_view(text));
    if (!read) return;
    if (const toml::table *states = read.table()["states"].as_table()) add_states(*states, "", out.states);
    out.goes = has_key(read.table(), "go");
    if (!read.table().contains("places")) text += section_of(places);
}

Machine add_machine(clq_stage *stage, const std::string &path, const std::vector<Place> &places, const People &people,
                    const std::vector<size_t> &members)
{
    std::string text;
    const std::string wrong = io::read_whole(path, text);
    if (!wrong.empty()) throw Failure(wrong);
    Machine made;
    look_into(text, places, made);
    std::vector<const clq_template *> templates;
    std::vector<const clq_locomotion *> locomotions;
    for (const size_t member : members) {
        const walkers::Member &one = people.cast()[member];
        if (std::find(templates.begin(), templates.end(), one.tmpl) != templates.end()) continue;
        templates.push_back(one.tmpl);
        locomotions.push_back(one.locomotion.get());
    }
    clq_machine_def def = clq_machine_def_init();
    def.source.text = text.data(), def.source.text_bytes = text.size(), def.source.name = path.c_str();
    def.template_count = static_cast<uint32_t>(templates.size());
    def.templates = templates.data(), def.locomotions = locomotions.data();
    check(clq_stage_add_machine(stage, &def, &made.id));
    return made;
}

}  // namespace

std::map<std::string, Machine> add_machines(clq_stage *stage, const Staging &described, const People &people)
{
    std::map<std::string, Machine> made;
    for (const ScenarioAgents &first : described.agents) {
        if (made.count(first.machine)) continue;
        std::vector<size_t> members;
        for (const ScenarioAgents &each : described.agents)
            if (each.machine == first.machine) members.push_back(each.member);
        made[first.machine] = asked_at(
            first.machine_at, [&] { return add_machine(stage, first.machine, described.places, people, members); });
    }
    return made;
}

}  // namespace staged
