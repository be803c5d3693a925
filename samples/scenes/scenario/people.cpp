// [[people]]: single individuals with roles.
#include <cmath>

#include "lib/base/near_names.h"
#include "samples/io/whole_number.h"
#include "samples/scenes/check.h"
#include "samples/scenes/scenario/sections.h"

namespace scenes
{
namespace
{

using namespace roles;

constexpr Limits at_times = {-1e9, 1e9}, of_speeds = {-100, 100}, of_world = {-1e9, 1e9};
constexpr size_t most_roles = 10000, most_corners = 1000;

size_t member_of(TomlTable &table, const Scenario &scenario)
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

Clip clip_of(TomlTable &table)
{
    Clip clip;
    if (table.has("clip")) clip.name = table.text("clip");
    if (table.has("start_s")) clip.start_s = table.number("start_s", at_times);
    if (table.has("speed")) clip.speed = static_cast<float>(table.number("speed", of_speeds));
    if (table.has("phase_s")) clip.phase_s = static_cast<float>(table.number("phase_s", at_times));
    return clip;
}

int curve_of(TomlTable &table)
{
    const std::string name = table.text("curve");
    if (name == "linear") return CLQ_CURVE_LINEAR;
    if (name == "smooth") return CLQ_CURVE_SMOOTH;
    if (name == "inertial") return CLQ_CURVE_INERTIAL;
    table.refuse("has the curve '" + name + "': linear, smooth or inertial", "curve");
}

void read_motion(TomlTable &table, Motion &out)
{
    out.base = clip_of(table);
    if (table.has("treadmill_m_s")) out.treadmill_m_s = table.number("treadmill_m_s", {0, 12});
    if (table.has("fades"))
        for (TomlTable &one : table.tables("fades", "the fade")) {
            Fade fade;
            fade.to = clip_of(one);
            fade.at_s = one.number("at_s", at_times);
            if (one.has("length_s")) fade.length_s = static_cast<float>(one.number("length_s", {0, 1000}));
            if (one.has("curve")) fade.curve = curve_of(one);
            one.done();
            out.fades.push_back(fade);
        }
    if (out.fades.size() > most_fades)
        table.refuse("has " + std::to_string(out.fades.size()) + " fades; at most 3 are remembered", "fades");
    if (table.has("layers"))
        for (TomlTable &one : table.tables("layers", "the layer")) {
            Layer layer;
            layer.clip = clip_of(one);
            if (one.has("joint")) layer.joint = one.text("joint");
            if (one.has("all_but")) layer.inverted = one.flag("all_but");
            if (one.has("adds")) layer.adds = one.flag("adds");
            if (one.has("weight")) layer.weight = static_cast<float>(one.number("weight", {-4, 4}));
            one.done();
            out.layers.push_back(layer);
        }
    if (out.layers.size() > most_layers)
        table.refuse("has " + std::to_string(out.layers.size()) + " layers; at most 4 are shown", "layers");
}

void read_face(TomlTable &table, Face &out)
{
    if (table.has("looks")) out.looks = table.flag("looks");
    if (table.has("look_at")) out.target = table.triple("look_at", of_world, "[x, y, z]");
    if (table.has("look_at_s")) out.target_at_s = table.number("look_at_s", at_times);
    out.looks = out.looks || out.target;
    if (table.has("blinks")) out.blinks = table.flag("blinks");
    if (table.has("expression")) out.expresses = true, out.expression = table.text("expression");
    if (table.has("expression_s")) out.expression_at_s = table.number("expression_s", at_times);
    if (table.has("phrase")) out.phrase = table.text("phrase");
    if (table.has("phrase_s")) out.phrase_at_s = table.number("phrase_s", at_times);
}

// Without the option the file is not even looked for.
MechanismFile mechanism_of(TomlTable &table, const ScenarioFiles &files)
{
    return {files.mechanisms, files.mechanisms.empty() ? table.text("mechanism") : file_of(table, "mechanism", files)};
}

void read_rest(TomlTable &table, const ScenarioFiles &files, Role &out)
{
    if (table.has("flight")) {
        out.flight.corners = table.numbers("flight", of_world);
        const size_t count = out.flight.corners.size();
        if (count < 6 || count % 3 != 0 || count > 3 * most_corners)
            table.refuse(
                "has a flight of " + std::to_string(count) + " numbers; it needs x, y and z of 2 to 1000 corners",
                "flight");
    }
    if (table.has("flight_m_s")) out.flight.speed_m_s = table.number("flight_m_s", {0.1, 1000});
    if (table.has("carries"))
        for (TomlTable &one : table.tables("carries", "what it carries")) {
            out.load.push_back({one.text("joint"), one.text("object")});
            one.done();
        }
    if (table.has("mechanism"))
        out.mechanism = asked_at(table.place("mechanism"), [&] { return mechanism_of(table, files); });
    if (!table.has("dofs")) return;
    TomlTable dofs = table.table("dofs", "its degrees of freedom");
    for (const std::string &name : dofs.names()) out.dofs[name] = static_cast<float>(dofs.number(name, of_world));
    dofs.done();
}

void read_looks(TomlTable &table, Person &out)
{
    if (table.has("orientation")) {
        const std::vector<double> q = table.numbers("orientation", {-1.001, 1.001});
        if (q.size() != 4) table.refuse("has an orientation that is no quaternion [x, y, z, w]", "orientation");
        const double length = std::sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
        if (!(std::fabs(length - 1) <= 1e-3))
            table.refuse("has an orientation of length " + show(length) + " instead of 1", "orientation");
        for (size_t k = 0; k < 4; ++k) out.orientation[k] = static_cast<float>(q[k]);
    }
    if (table.has("scale")) out.scale = static_cast<float>(table.number("scale", {1e-4, 1e4}));
    if (table.has("seed") && !io::read_whole_number(table.text("seed"), out.seed))
        table.refuse("has the seed '" + table.text("seed") + "', which is not " + io::whole_number_rule, "seed");
    if (table.has("textures")) out.textures = table.text("textures");
    if (!table.has("colours")) return;
    const std::vector<double> bytes = table.numbers("colours", {0, 255});
    if (bytes.size() % 3 != 0) table.refuse("has colours that are not red, green and blue for each zone", "colours");
    for (size_t i = 0; i < bytes.size(); i += 3)
        out.colours.push_back(
            {static_cast<uint8_t>(bytes[i]), static_cast<uint8_t>(bytes[i + 1]), static_cast<uint8_t>(bytes[i + 2])});
}

}  // namespace

void read_people(TomlTable &all, const ScenarioFiles &files, Scenario &scenario)
{
    std::vector<TomlTable> people = all.tables("people", "[[people]]");
    if (people.empty() || people.size() > most_roles)
        all.refuse("has " + std::to_string(people.size()) + " people; it needs 1 to 10000", "people");
    for (TomlTable &described : people) {
        Person made;
        made.at_file = described.place();
        made.member = member_of(described, scenario);
        made.character = scenario.characters[made.member].character;
        made.at = described.triple("at", of_world, "[x, y, z]");
        read_looks(described, made);
        read_motion(described, made.role.motion);
        read_face(described, made.role.face);
        read_rest(described, files, made.role);
        described.done();
        scenario.people.push_back(std::move(made));
    }
}

}  // namespace scenes
