// Motion: the treadmill, and layers over parts of the body.
#include <cmath>

#include "samples/view/ground/ground_panels.h"

namespace view
{
namespace
{

using scenes::roles::Layer;
using scenes::roles::Role;

const char *gait_of(const clq_track_state &state)
{
    if (state.stands || state.gait < 0.05f) return "stands";
    return state.gait < 0.95f ? "short steps" : state.gait < 1.5f ? "walks" : "runs";
}

void treadmill(Ui &ui, Model &model, Role &role)
{
    Ground &ground = model.ground;
    std::optional<double> &speed = role.motion.treadmill_m_s;
    bool on = speed.has_value();
    const bool turned = ui.toggle("treadmill", on);
    const bool changed = ui.slider("walking speed", ground.walking_m_s, 0, 6, "%.2f m/s");
    if (turned && !on) speed.reset();
    // Each speed is a track of its own, so they go by steps.
    if (on && (turned || changed)) speed = std::round(static_cast<double>(ground.walking_m_s) * 20) / 20;
    if (!ground.treadmill) return;
    const OnTreadmill &shown = *ground.treadmill;
    ui.row("gait", gait_of(shown.state) + std::string(", ") + fixed(static_cast<double>(shown.state.gait), 2));
    ui.row("foot drift",
           shown.steps == 0 ? std::string("no foot stands") : fixed(shown.drift_most_mm, 1) + " mm at most");
    ui.row("", fixed(shown.drift_mean_mm, 1) + " mm in the mean of " + std::to_string(shown.steps) + " steps");
}

void choose_mask(Ui &ui, Layer &layer, const std::vector<std::string> &joints)
{
    std::vector<std::string> items = {"whole body"};
    items.insert(items.end(), joints.begin(), joints.end());
    int chosen = -1;
    for (size_t i = 0; i < items.size(); ++i)
        if (layer.joint == (i == 0 ? "" : items[i])) chosen = static_cast<int>(i);
    if (ui.choice("mask", chosen, items)) layer.joint = chosen == 0 ? "" : items[static_cast<size_t>(chosen)];
    ui.text_field("joint", layer.joint);
    if (!layer.joint.empty()) ui.toggle("all but it", layer.inverted);
}

void layers(Ui &ui, Model &model, Role &role, const std::vector<std::string> &joints)
{
    Ground &ground = model.ground;
    std::vector<Layer> &all = role.motion.layers;
    const std::vector<std::string> &clips = ground.can.clips;
    if (clips.empty()) return ui.faint("It has no clips for layers.");
    if (all.size() < scenes::roles::most_layers && ui.button("add layer")) {
        Layer layer;
        layer.clip.name = clips[0];
        layer.clip.start_s = model.clock.time_s;
        all.push_back(layer);
        ground.layer = all.size() - 1;
    }
    if (all.empty()) return;
    const bool drop = ui.button("drop layer", all.size() < scenes::roles::most_layers);
    std::vector<std::string> numbers;
    for (size_t i = 0; i < all.size(); ++i) numbers.push_back(std::to_string(i + 1));
    ground.layer = std::min(ground.layer, all.size() - 1);
    int chosen = static_cast<int>(ground.layer);
    if (ui.choice("layer", chosen, numbers)) ground.layer = static_cast<size_t>(chosen);
    Layer &layer = all[ground.layer];
    int clip = -1;
    for (size_t i = 0; i < clips.size(); ++i)
        if (clips[i] == layer.clip.name) clip = static_cast<int>(i);
    if (ui.choice("layer plays", clip, clips)) layer.clip.name = clips[static_cast<size_t>(clip)];
    int adds = layer.adds ? 1 : 0;
    if (ui.choice("kind", adds, {"replaces", "adds"})) layer.adds = adds == 1, layer.weight = 1;
    ui.slider("weight", layer.weight, layer.adds ? -2.0f : 0.0f, layer.adds ? 2.0f : 1.0f, "%.2f");
    choose_mask(ui, layer, joints);
    if (drop) all.erase(all.begin() + static_cast<std::ptrdiff_t>(ground.layer));
}

}  // namespace

void motion_panel(Ui &ui, Model &model, Role &role, const clq_template *tmpl)
{
    treadmill(ui, model, role);
    layers(ui, model, role, joints_of(tmpl));
}

}  // namespace view
