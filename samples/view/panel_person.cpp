// The individual that was picked: its identity, and how it was drawn.
#include <cmath>

#include "samples/view/panels.h"

namespace view
{
namespace
{

// A line for each clip that moves it.
void clip_rows(Ui &ui, const Model &model, const World &world, const clq_template *tmpl)
{
    clq_active_clip clips[CLQ_ACTIVE_CLIP_MAX] = {};
    uint32_t count = 0;
    if (clq_actor_get_active_clips(world.crowd(), model.picked.actor, model.clock.time_s, clips, &count) != CLQ_OK)
        return ui.row("clip", "not known");
    if (count == 0) ui.row("clip", "rest pose");
    for (uint32_t k = 0; k < count; ++k) {
        std::string text = "rest pose";
        clq_clip_info clip = clq_clip_info_init();
        if (clips[k].clip != CLQ_NONE && clq_template_get_clip(tmpl, clips[k].clip, &clip) == CLQ_OK)
            text = std::string(clip.name) + " at " + fixed(clips[k].clip_time_s, 2) + " s";
        if (clips[k].kind != CLQ_LAYER_REPLACE || clips[k].weight < 1)
            text += " (" + fixed(static_cast<double>(clips[k].weight) * 100, 0) + " %)";
        ui.row(k == 0 ? "clip" : "", text);
    }
}

void zone_row(Ui &ui, const Model &model, const World &world, const clq_template *tmpl)
{
    clq_zone_info zone = clq_zone_info_init();
    if (model.picked.zone == CLQ_NONE || clq_template_get_zone(tmpl, model.picked.zone, &zone) != CLQ_OK) return;
    const std::vector<uint8_t> rgb = world.colours(model.picked.actor);
    ui.row("zone", zone.name);
    const size_t at = 3 * static_cast<size_t>(model.picked.zone);
    if (at + 2 >= rgb.size()) return;
    const float shown[3] = {static_cast<float>(rgb[at]) / 255, static_cast<float>(rgb[at + 1]) / 255,
                            static_cast<float>(rgb[at + 2]) / 255};
    ui.swatch(shown, "red " + std::to_string(rgb[at]) + ", green " + std::to_string(rgb[at + 1]) + ", blue " +
                         std::to_string(rgb[at + 2]));
}

void drawing_rows(Ui &ui, const clq_actor_info &info, double time_s)
{
    ui.row("distance", fixed(static_cast<double>(info.eye_distance_m), 2) + " m");
    clq_template_info tmpl = clq_template_info_init();
    clq_level_info level = clq_level_info_init();
    if (clq_template_get_info(info.tmpl, &tmpl) != CLQ_OK) return;
    ui.row("level", std::to_string(info.level) + " of 0 to " + std::to_string(tmpl.level_count - 1));
    if (clq_template_get_level(info.tmpl, info.level, &level) == CLQ_OK)
        ui.row("triangles", whole(level.triangle_count) + " of " + whole(tmpl.triangle_count));
    const double period = static_cast<double>(info.period_s);
    ui.row("rate", period > 0 ? fixed(1 / period, 1) + " poses/s" : "every frame");
    ui.row("tick", fixed(info.tick_s, 3) + " s, " + fixed((time_s - info.tick_s) * 1000, 0) + " ms old");
    const double scale = std::fabs(static_cast<double>(info.root.scale));
    ui.row("spheres", "root " + fixed(static_cast<double>(info.sklsroot_radius) * scale, 2) + " m, point " +
                          fixed(static_cast<double>(info.refpoint_radius) * scale, 2) + " m");
}

}  // namespace

void person_panel(Ui &ui, Model &model, const World &world)
{
    clq_actor_info info = clq_actor_info_init();
    if (!world.find(model.picked.actor, info)) {
        ui.faint("Click a person in the picture.");
        return;
    }
    clq_template_info tmpl = clq_template_info_init();
    if (clq_template_get_info(info.tmpl, &tmpl) != CLQ_OK) return;
    bool follows = model.view.mode == CameraMode::follow;
    if (ui.toggle("follow", follows)) model.view.mode = follows ? CameraMode::follow : CameraMode::free;
    if (ui.button("frame", true)) model.wishes.frame_selection = true;
    const bool let_go = ui.button("let go", true);
    ui.row("person", std::to_string(model.picked.actor.index1) + ", made " +
                         (model.picked.actor.generation > 1 ? std::to_string(model.picked.actor.generation) + " times"
                                                            : std::string("once")));
    ui.row("template", tmpl.name);
    if (tmpl.texture_set_count > 1) {
        const char *set = clq_template_get_texture_set_name(info.tmpl, info.texture_set);
        ui.row("textures", *set != 0 ? set : info.texture_set == 0 ? "own" : "set " + std::to_string(info.texture_set));
    }
    zone_row(ui, model, world, info.tmpl);
    clip_rows(ui, model, world, info.tmpl);
    if (info.visible) drawing_rows(ui, info, world.shown_s());
    else ui.faint("It is out of view.");
    if (let_go) model.picked = {};
}

}  // namespace view
