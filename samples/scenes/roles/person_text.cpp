// People as [[people]], to the last bit of every number.
#include <cstdio>

#include "samples/scenes/roles/person.h"

namespace scenes::roles
{
namespace
{

std::string number(double value)
{
    char text[40];
    std::snprintf(text, sizeof text, "%.17g", value);
    std::string out = text;
    // TOML reads 3 as a whole number where a fraction is wanted.
    if (out.find_first_of(".en") == std::string::npos) out += ".0";
    return out;
}

std::string number(float value)
{
    char text[40];
    std::snprintf(text, sizeof text, "%.9g", static_cast<double>(value));
    std::string out = text;
    if (out.find_first_of(".en") == std::string::npos) out += ".0";
    return out;
}

std::string quoted(const std::string &text)
{
    std::string out = "\"";
    for (const char c : text) {
        if (c == '"' || c == '\\') out += '\\';
        if (static_cast<unsigned char>(c) >= ' ') out += c;
    }
    return out + "\"";
}

template <class List>
std::string list(const List &values)
{
    std::string out = "[";
    for (const auto &value : values) out += (out.size() > 1 ? ", " : "") + number(value);
    return out + "]";
}

std::string line(const char *key, const std::string &value) { return std::string(key) + " = " + value + "\n"; }

std::string clip(const Clip &one, const char *between)
{
    const std::string sep = between;
    std::string out = "clip = " + quoted(one.name) + sep + "start_s = " + number(one.start_s);
    if (one.speed != 1) out += sep + "speed = " + number(one.speed);
    if (one.phase_s != 0) out += sep + "phase_s = " + number(one.phase_s);
    return out;
}

std::string motion(const Motion &m)
{
    static const char *const curves[] = {"linear", "smooth", "inertial"};
    std::string out = clip(m.base, "\n") + "\n";
    if (m.treadmill_m_s) out += line("treadmill_m_s", number(*m.treadmill_m_s));
    std::string fades, layers;
    for (const Fade &one : m.fades)
        fades += "    { " + clip(one.to, ", ") + ", at_s = " + number(one.at_s) +
                 ", length_s = " + number(one.length_s) + ", curve = " + quoted(curves[one.curve]) + " },\n";
    for (const Layer &one : m.layers) {
        layers += "    { " + clip(one.clip, ", ") + ", weight = " + number(one.weight);
        if (!one.joint.empty()) layers += ", joint = " + quoted(one.joint);
        if (one.inverted) layers += ", all_but = true";
        if (one.adds) layers += ", adds = true";
        layers += " },\n";
    }
    if (!fades.empty()) out += "fades = [\n" + fades + "]\n";
    if (!layers.empty()) out += "layers = [\n" + layers + "]\n";
    return out;
}

std::string face(const Face &f)
{
    std::string out;
    if (f.looks) out += line("looks", "true");
    if (f.target) out += line("look_at", list(*f.target));
    if (f.looks) out += line("look_at_s", number(f.target_at_s));
    if (f.blinks) out += line("blinks", "true");
    if (f.expresses) out += line("expression", quoted(f.expression)) + line("expression_s", number(f.expression_at_s));
    if (!f.phrase.empty()) out += line("phrase", quoted(f.phrase)) + line("phrase_s", number(f.phrase_at_s));
    return out;
}

std::string rest(const Role &role)
{
    std::string out;
    if (role.flight.flies())
        out += line("flight", list(role.flight.corners)) + line("flight_m_s", number(role.flight.speed_m_s));
    if (!role.mechanism.empty()) out += line("mechanism", quoted(role.mechanism.path()));
    std::string load, dofs;
    for (const Carried &one : role.load)
        load += "    { joint = " + quoted(one.joint) + ", object = " + quoted(one.object) + " },\n";
    if (!load.empty()) out += "carries = [\n" + load + "]\n";
    for (const auto &[name, value] : role.dofs)
        dofs += (dofs.empty() ? "" : ", ") + quoted(name) + " = " + number(value);
    if (!dofs.empty()) out += line("dofs", "{ " + dofs + " }");
    return out;
}

}  // namespace

std::string text_of(const std::string &name, const std::vector<Person> &people, const std::string &camera)
{
    std::string out = line("name", quoted(name));
    std::vector<std::string> characters;
    for (const Person &one : people) {
        bool known = false;
        for (const std::string &other : characters) known = known || other == one.character;
        if (known) continue;
        characters.push_back(one.character);
        out += "\n[[characters]]\n" + line("name", quoted(one.character)) + line("character", quoted(one.character));
        const Placement &placed = one.placement;
        for (const auto &[key, value] :
             {std::pair("turn_deg", placed.turn_deg), {"height_m", placed.height_m}, {"scale", placed.scale}})
            if (value != 0) out += line(key, number(value));
        if (placed.blend) out += line("blend", quoted(placed.blend == CLQ_BLEND_OPAQUE ? "opaque" : "mask"));
    }
    for (const Person &one : people) {
        out += "\n[[people]]\n" + line("class", quoted(one.character)) + line("at", list(one.at)) +
               line("orientation", list(one.orientation)) + line("scale", number(one.scale)) +
               line("seed", quoted(std::to_string(one.seed)));
        if (!one.textures.empty()) out += line("textures", quoted(one.textures));
        std::string colours;
        for (const auto &rgb : one.colours)
            colours += (colours.empty() ? "" : ", ") + std::to_string(rgb[0]) + ", " + std::to_string(rgb[1]) + ", " +
                       std::to_string(rgb[2]);
        if (!colours.empty()) out += line("colours", "[" + colours + "]");
        out += motion(one.role.motion) + face(one.role.face) + rest(one.role);
    }
    return out + (camera.empty() ? "" : "\n" + camera);
}

}  // namespace scenes::roles
