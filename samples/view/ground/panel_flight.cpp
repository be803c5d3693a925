// Flight and load: a path to draw, things to carry, and a mechanism of one's own.
#include "samples/view/ground/ground_panels.h"

namespace view
{
namespace
{

using scenes::roles::Flight;
using scenes::roles::MechanismFile;
using scenes::roles::Role;

void path(Ui &ui, Model &model, Flight &flight)
{
    mouse_choice(ui, model, "left click", Tool::path, "adds a corner");
    ui.slider("height", model.ground.height_m, 0, 20, "%.1f m");
    if (flight.corners.empty()) return;
    float speed = static_cast<float>(flight.speed_m_s);
    if (ui.slider("flight speed", speed, 0.2f, 30, "%.1f m/s")) flight.speed_m_s = static_cast<double>(speed);
    const bool forget = ui.button("forget path");
    ui.faint(std::to_string(flight.corners.size() / 3) + (flight.flies() ? " corners" : " corner; two make a path"));
    if (forget) flight.corners.clear();
}

void load(Ui &ui, Model &model, Role &role, const std::vector<std::string> &joints)
{
    Ground &ground = model.ground;
    ui.choice("object", ground.object, scenes::roles::object_names());
    ui.text_field("hold in", ground.hold_in);
    int joint = -1;
    if (!joints.empty() && ui.choice("joints", joint, joints)) ground.hold_in = joints[static_cast<size_t>(joint)];
    if (ui.button("give")) {
        const std::string &object = scenes::roles::object_names()[static_cast<size_t>(ground.object)];
        role.load.push_back({ground.hold_in, object});
    }
    if (role.load.empty()) return;
    const bool down = ui.button("put down", true);
    for (const scenes::roles::Carried &one : role.load) ui.row(one.object.c_str(), one.joint);
    if (down) role.load.clear();
}

void own_mechanism(Ui &ui, Model &model, Role &role)
{
    ui.text_field("mechanism", model.ground.mechanism);
    if (ui.button("load")) try {
            role.mechanism = MechanismFile(model.ground.mechanisms, model.ground.mechanism);
        } catch (const scenes::Failure &failure) {
            model.message = failure.what();
        }
    if (role.mechanism.empty()) return;
    if (ui.button("take it off", true)) role.mechanism = {};
    if (!model.ground.mechanism_name.empty()) ui.row("runs", model.ground.mechanism_name);
}

}  // namespace

void flight_panel(Ui &ui, Model &model, Role &role, const clq_template *tmpl)
{
    path(ui, model, role.flight);
    load(ui, model, role, joints_of(tmpl));
    own_mechanism(ui, model, role);
}

}  // namespace view
