// [[doors]] and [[agents]]: what opens and closes, and people that run machines.
#include <algorithm>

#include "lib/base/near_names.h"
#include "samples/scenes/scenario/sections.h"

namespace scenes
{
namespace
{

constexpr Limits of_time_s = {0, 86400};
constexpr size_t most_doors = 62, most_agents = 16000;

size_t place_named(TomlTable &table, const Staging &stage, const std::string &name, const char *key)
{
    std::vector<std::string> names;
    for (const auto &place : stage.places) {
        if (place.name == name) return names.size();
        names.push_back(place.name);
    }
    table.refuse("has '" + std::string(key) + "' with '" + name + "', and [places] has no such place" +
                     claque::base::names_near(name, names),
                 key);
}

std::vector<size_t> places_named(TomlTable &table, const Staging &stage, const char *key)
{
    std::vector<size_t> found;
    for (const std::string &name : table.texts(key)) found.push_back(place_named(table, stage, name, key));
    if (found.empty()) table.refuse("has '" + std::string(key) + "' without a place", key);
    return found;
}

size_t class_named(TomlTable &table, const Scenario &scenario)
{
    const std::string name = table.text("class");
    std::vector<std::string> names;
    for (const SocialClass &one : scenario.characters) {
        if (one.name == name) return names.size();
        names.push_back(one.name);
    }
    table.refuse("is of the class '" + name + "', and there is no [[characters]] of that name" +
                     claque::base::names_near(name, names),
                 "class");
}

void read_where(TomlTable &described, const Staging &stage, ScenarioAgents &made)
{
    const bool at = described.has("from"), within = described.has("area");
    if (at == within)
        described.refuse("needs either 'from', a list of places, or 'area'; it has " +
                         std::string(at ? "both" : "neither"));
    if (at) made.from = places_named(described, stage, "from");
    else made.outline = read_outline(described, "area");
    if (described.has("within_m")) made.within_m = described.number("within_m", {0, 100});
    if (described.has("apart_m")) made.apart_m = described.number("apart_m", {0, 100});
    if (described.has("heading_deg")) made.heading_deg = described.number("heading_deg", {-360, 360});
    if (described.has("exits")) made.exits = places_named(described, stage, "exits");
    if (!described.has("exit_widths_m")) return;
    made.exit_widths_m = described.numbers("exit_widths_m", {0.1, 1000});
    if (made.exit_widths_m.size() != made.exits.size())
        described.refuse("has " + std::to_string(made.exits.size()) + " 'exits' and " +
                             std::to_string(made.exit_widths_m.size()) + " widths of them",
                         "exit_widths_m");
}

void read_when(TomlTable &described, const Staging &stage, ScenarioAgents &made)
{
    if (described.has("from_s")) made.from_s = described.number("from_s", of_time_s);
    if (described.has("per_minute")) made.per_minute = described.number("per_minute", {0.001, 100000});
    if (!stage.ground)
        for (const char *key : {"from_s", "per_minute", "exits"})
            described.expect_no(key, "which goes with [navigation]: people who come and leave have to walk");
}

}  // namespace

void read_doors(TomlTable &all, const ScenarioFiles &, Scenario &scenario)
{
    Staging &stage = stage_of(all, "doors", scenario);
    if (!stage.ground) all.refuse("has doors, and no [navigation] with a ground that they could close", "doors");
    for (TomlTable &described : all.tables("doors", "[[doors]]")) {
        ScenarioDoor made;
        made.at = described.place();
        made.name = described.text("name");
        made.outline = read_outline(described, "area");
        if (described.has("y_m")) {
            const auto y = described.pair("y_m", {-1000, 1000});
            if (!(y[0] < y[1])) described.refuse("has its heights in the wrong order", "y_m");
            made.low_m = y[0], made.high_m = y[1];
        }
        if (described.has("open")) made.open = described.flag("open");
        if (described.has("opens_s"))
            for (const double at_s : described.numbers("opens_s", of_time_s)) made.changes.push_back({at_s, true});
        if (described.has("closes_s"))
            for (const double at_s : described.numbers("closes_s", of_time_s)) made.changes.push_back({at_s, false});
        std::stable_sort(made.changes.begin(), made.changes.end(),
                         [](const auto &a, const auto &b) { return a.at_s < b.at_s; });
        described.done();
        for (const ScenarioDoor &other : stage.doors)
            if (other.name == made.name) described.refuse("is a second door '" + made.name + "'", "name");
        stage.doors.push_back(std::move(made));
        if (stage.doors.size() > most_doors)
            described.refuse("is one too many: a scenario has at most " + std::to_string(most_doors) + " doors");
    }
}

void read_agents(TomlTable &all, const ScenarioFiles &files, Scenario &scenario)
{
    Staging &stage = stage_of(all, "agents", scenario);
    size_t sum = 0;
    for (TomlTable &described : all.tables("agents", "[[agents]]")) {
        ScenarioAgents made;
        made.at = described.place();
        made.member = class_named(described, scenario);
        made.name = described.has("name") ? described.text("name") : scenario.characters[made.member].name;
        made.machine = file_of(described, "machine", files);
        made.machine_at = described.place("machine");
        if (described.has("count")) made.count = described.whole("count", {1, most_agents});
        read_where(described, stage, made);
        read_when(described, stage, made);
        described.done();
        sum += made.count;
        if (sum > most_agents)
            described.refuse(
                "makes " + std::to_string(sum) + " people; a scenario has at most " + std::to_string(most_agents),
                "count");
        stage.agents.push_back(std::move(made));
    }
    if (stage.agents.empty()) all.refuse("has an empty list of agents", "agents");
}

}  // namespace scenes
