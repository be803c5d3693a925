// The testing ground of the picked individual's character: its clips, its degrees of freedom, its levels, and what the
// library said about it.
#include "samples/view/ground/ground_panels.h"

namespace view
{
namespace
{

void fade_to(Model &model, const World &world, const std::string &clip)
{
    scenes::roles::Fade fade;
    fade.to.name = clip;
    fade.to.start_s = fade.at_s = model.clock.time_s;
    fade.length_s = model.fade_s, fade.curve = model.curve;
    add_fade(picked_role(model, world)->motion, fade);
}

// The clip that moves it most at this time; -1: none does.
int main_clip(const Model &model, const World &world)
{
    clq_active_clip active[CLQ_ACTIVE_CLIP_MAX] = {};
    uint32_t count = 0;
    if (clq_actor_get_active_clips(world.crowd(), model.picked.actor, model.clock.time_s, active, &count) != CLQ_OK)
        return -1;
    int found = -1;
    float most = 0;
    for (uint32_t k = 0; k < count; ++k)
        if (active[k].clip != CLQ_NONE && active[k].kind == CLQ_LAYER_REPLACE && active[k].weight >= most)
            found = static_cast<int>(active[k].clip), most = active[k].weight;
    return found;
}

void clips(Ui &ui, Model &model, const World &world, const clq_template *tmpl, uint32_t count)
{
    std::vector<std::string> names;
    for (uint32_t k = 0; k < count; ++k) {
        clq_clip_info clip = clq_clip_info_init();
        if (clq_template_get_clip(tmpl, k, &clip) == CLQ_OK) names.emplace_back(clip.name);
    }
    int chosen = main_clip(model, world);
    if (!names.empty() && ui.choice("clip", chosen, names)) fade_to(model, world, names[static_cast<size_t>(chosen)]);
    if (names.empty()) return ui.faint("It has no clips.");
    ui.slider("fade", model.fade_s, 0, 2, "%.2f s");
    ui.choice("curve", model.curve, {"linear", "smooth", "inertial"});
}

void degrees_of_freedom(Ui &ui, Model &model, const World &world, const clq_template *tmpl, uint32_t count)
{
    if (count == 0) return ui.faint("It has no degrees of freedom.");
    std::map<std::string, float> values;
    const auto role = model.ground.roles.find(model.picked.actor.index1);
    if (role != model.ground.roles.end()) values = role->second.dofs;
    const bool held = !values.empty();
    bool changed = false;
    for (uint32_t k = 0; k < count; ++k) {
        clq_dof_info dof = clq_dof_info_init();
        if (clq_template_get_dof(tmpl, k, &dof) != CLQ_OK) continue;
        const auto found = values.find(dof.name);
        float value = found != values.end() ? found->second : dof.rest;
        if (!ui.slider(dof.name, value, dof.min, dof.max, "%.2f")) continue;
        values[dof.name] = value;
        changed = true;
    }
    if (changed) picked_role(model, world)->dofs = values;
    if (held && ui.button("leave joints to clips")) picked_role(model, world)->dofs.clear();
}

void levels(Ui &ui, const clq_template *tmpl, const clq_template_info &info)
{
    ui.text("levels: from, triangles, vertices, nodes");
    for (uint32_t k = 0; k < info.level_count; ++k) {
        clq_level_info level = clq_level_info_init();
        if (clq_template_get_level(tmpl, k, &level) != CLQ_OK) continue;
        ui.faint(std::to_string(k) + ": " + fixed(static_cast<double>(level.lod_min_m), 1) + " m, " +
                 whole(level.triangle_count) + ", " + whole(level.vertex_count) + ", " + whole(level.node_count));
    }
}

}  // namespace

void character_panel(Ui &ui, Model &model, const World &world)
{
    clq_actor_info info = clq_actor_info_init();
    if (!world.find(model.picked.actor, info)) return ui.faint("Click a person to test its character.");
    clq_template_info tmpl = clq_template_info_init();
    if (clq_template_get_info(info.tmpl, &tmpl) != CLQ_OK) return;
    ui.row("character", tmpl.name);
    ui.row("triangles", whole(tmpl.triangle_count) + ", " + whole(tmpl.dirty_count) + " in several zones");
    ui.row("zones", whole(tmpl.zone_count));
    ui.row("memory", memory(tmpl.bytes));
    clips(ui, model, world, info.tmpl, tmpl.clip_count);
    degrees_of_freedom(ui, model, world, info.tmpl, tmpl.dof_count);
    if (ui.button("save scenario")) model.ground.save_scenario = true;
    levels(ui, info.tmpl, tmpl);
    const std::vector<std::string> warnings = world.warnings();
    if (warnings.empty()) ui.faint("The library has no warnings.");
    for (const std::string &warning : warnings) ui.warning(warning);
}

}  // namespace view
