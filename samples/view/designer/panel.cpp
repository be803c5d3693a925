#include "samples/view/designer/panel.h"

#include <claque/mesh.h>

#include <algorithm>
#include <cmath>

#include "samples/view/designer/painting.h"
#include "samples/view/designer/widgets.h"
#include "samples/view/panels.h"

namespace view
{
namespace
{

struct Subject {
    const clq_template *tmpl = nullptr;
    clq_template_info info = clq_template_info_init();
    clq_zone_info zone = clq_zone_info_init();
};

// A click on a person chooses its template and the zone under the mouse.
void follow_pick(Designer &d, const Model &model, const World &world)
{
    if (d.seen_pick == model.picks) return;
    d.seen_pick = model.picks;
    clq_actor_info info = clq_actor_info_init();
    clq_template_info tmpl = clq_template_info_init();
    clq_zone_info zone = clq_zone_info_init();
    if (!world.find(model.picked.actor, info) || clq_template_get_info(info.tmpl, &tmpl) != CLQ_OK) return;
    d.tmpl = tmpl.name;
    d.entry = 0;
    if (clq_template_get_zone(info.tmpl, model.picked.zone, &zone) == CLQ_OK) d.zone = zone.name;
}

void changes(Ui &ui, Designer &d)
{
    if (ui.button("undo")) d.wishes.undo = true;
    if (ui.button("redo", true)) d.wishes.redo = true;
    if (ui.button("load map", true)) d.wishes.load = true;
    if (ui.button("save map", true)) d.wishes.save = true;
    ui.text_field("map file", d.file);
}

void people(Ui &ui, Designer &d, const World &world)
{
    const auto now = static_cast<float>(d.people > 0 ? d.people : clq_crowd_get_actor_count(world.crowd()));
    float wanted = now;
    if (ui.number("people", wanted, 1, 5000, "%.0f", 0.5f) && wanted != now)
        d.people = static_cast<uint32_t>(std::lround(wanted));
}

bool choose_template(Ui &ui, Designer &d, const World &world, Subject &out)
{
    std::vector<std::string> names;
    std::vector<const clq_template *> all;
    for (const clq_template *tmpl : world.templates()) {
        clq_template_info info = clq_template_info_init();
        if (clq_template_get_info(tmpl, &info) != CLQ_OK) continue;
        if (std::find(names.begin(), names.end(), info.name) != names.end()) continue;
        names.emplace_back(info.name);
        all.push_back(tmpl);
    }
    if (names.empty()) return false;
    auto at = static_cast<int>(std::find(names.begin(), names.end(), d.tmpl) - names.begin());
    if (at == static_cast<int>(names.size())) at = 0;
    if (ui.choice("template", at, names)) d.entry = 0;
    d.tmpl = names[static_cast<size_t>(at)];
    out.tmpl = all[static_cast<size_t>(at)];
    return clq_template_get_info(out.tmpl, &out.info) == CLQ_OK && out.info.zone_count > 0;
}

void choose_class(Ui &ui, Designer &d)
{
    const ColourClass *now = chosen_class(d);
    std::vector<std::string> names;
    for (const SharedClass &one : d.design.classes)
        if (!one->tmpl || one->tmpl == d.tmpl) names.push_back(one->name);
    if (!names.empty()) {
        auto at = static_cast<int>(std::find(names.begin(), names.end(), now ? now->name : "") - names.begin());
        if (ui.choice("class", at, names)) d.colour_class = names[static_cast<size_t>(at)];
        std::string name = now ? now->name : "";
        if (now && ui.text_field("class name", name)) name_class(d, name);
    } else ui.faint("No class is for this template yet: its people wear its own colours.");
    if (ui.button("add class")) add_class(d);
    if (now && ui.button("remove class", true)) remove_class(d);
}

void choose_set(Ui &ui, Designer &d, const Subject &subject)
{
    if (subject.info.texture_set_count < 2) return;
    std::vector<std::string> names = {"mixed"};
    for (uint32_t k = 0; k < subject.info.texture_set_count; ++k) {
        const char *name = clq_template_get_texture_set_name(subject.tmpl, k);
        names.push_back(*name ? name : k == 0 ? "own" : "set " + std::to_string(k));
    }
    const auto worn = d.sets.find(d.tmpl);
    int at = worn == d.sets.end() ? 0 : static_cast<int>(worn->second) + 1;
    if (!ui.choice("textures", at, names)) return;
    if (at == 0) d.sets.erase(d.tmpl);
    else d.sets[d.tmpl] = static_cast<uint32_t>(at - 1);
}

// Those that the finest level shows; others are baked for coarser ones.
std::vector<uint32_t> textures_of(const clq_template *tmpl)
{
    clq_mesh mesh = clq_mesh_init();
    scenes::check(clq_template_get_mesh(tmpl, 0, &mesh));
    std::vector<uint32_t> all;
    for (uint32_t bin = 0; bin < mesh.bin_count; ++bin) {
        clq_triangles triangles = clq_triangles_init();
        scenes::check(clq_template_get_triangles(tmpl, 0, bin, &triangles));
        if (std::find(all.begin(), all.end(), triangles.texture) == all.end()) all.push_back(triangles.texture);
    }
    std::sort(all.begin(), all.end());
    return all;
}

void texture(Ui &ui, Designer &d, const Subject &subject, bool paintable)
{
    const std::vector<uint32_t> all = textures_of(subject.tmpl);
    if (all.empty()) return;
    auto at = static_cast<int>(std::find(all.begin(), all.end(), d.texture) - all.begin());
    if (at == static_cast<int>(all.size())) at = 0;
    std::vector<std::string> names;
    for (const uint32_t texture : all) names.push_back(std::to_string(texture + 1));
    if (all.size() > 1) ui.choice("texture", at, names);
    d.texture = all[static_cast<size_t>(at)];
    texture_of_zones(ui, d, subject.tmpl, paintable);
}

void choose_zone_by_name(Ui &ui, Designer &d, Subject &subject)
{
    std::vector<std::string> names;
    for (uint32_t k = 0; k < subject.info.zone_count; ++k) {
        clq_zone_info zone = clq_zone_info_init();
        if (clq_template_get_zone(subject.tmpl, k, &zone) == CLQ_OK) names.emplace_back(zone.name);
    }
    // Zones that are about to be painted, or that the class names and the template lacks.
    const size_t own = names.size();
    std::vector<std::string> others = {d.brush.tool == BrushTool::pick ? "" : d.zone};
    if (const ColourClass *colours = chosen_class(d))
        for (const ZoneColours &zone : colours->zones) others.push_back(zone.zone);
    if (const SharedMap map = painted_map(d)) others.insert(others.begin(), map->names.begin(), map->names.end());
    for (const std::string &name : others)
        if (!name.empty() && std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
    auto at = static_cast<int>(std::find(names.begin(), names.end(), d.zone) - names.begin());
    if (at == static_cast<int>(names.size())) at = 0;
    if (ui.choice("zone", at, names)) d.entry = 0;
    d.zone = names[static_cast<size_t>(at)];
    subject.zone.range = clq_hsb_range_init();
    if (static_cast<size_t>(at) < own)
        scenes::check(clq_template_get_zone(subject.tmpl, static_cast<uint32_t>(at), &subject.zone));
}

void link(Ui &ui, Designer &d, const clq_hsb_range &own)
{
    const ColourClass *colours = chosen_class(d);
    const ZoneColours *zone = chosen_zone(d);
    std::vector<std::string> names = {"none"};
    if (colours)
        for (const std::string &name : leaders_for(*colours, d.zone)) names.push_back(name);
    auto at = static_cast<int>(std::find(names.begin(), names.end(), zone ? zone->linked_to : "") - names.begin());
    if (at == static_cast<int>(names.size())) at = 0;
    if (names.size() > 1 && ui.choice("linked to", at, names))
        link_zone(d, own, at == 0 ? "" : names[static_cast<size_t>(at)]);
    zone = chosen_zone(d);
    if (!zone || zone->linked_to.empty()) return;
    float variation = zone->variation;
    if (ui.number("variation", variation, 0, 1, "%.2f", 0.005f)) set_variation(d, variation, "variation");
    if (zone->palette.empty()) ui.faint("It shows the palette of " + zone->linked_to + ".");
}

void entries(Ui &ui, Designer &d, const clq_hsb_range &own, const std::vector<clq_palette_entry> &palette)
{
    if (palette.size() > 1) {
        palette_bar(ui, "palette", palette, d.entry);
        std::vector<std::string> numbers;
        for (size_t k = 0; k < palette.size(); ++k) numbers.push_back(std::to_string(k + 1));
        auto at = static_cast<int>(d.entry);
        if (ui.choice("entry", at, numbers)) d.entry = static_cast<size_t>(at);
        float weight = palette[d.entry].weight;
        if (ui.number("weight", weight, 0.01f, 1000, "%.3g", 0.02f)) set_weight(d, own, weight, "weight");
    }
    const ZoneColours *zone = chosen_zone(d);
    const bool several = zone && zone->palette.size() > 1;
    if (ui.button("add entry")) add_entry(d, own);
    if (several && ui.button("remove entry", true)) remove_entry(d);
}

void range(Ui &ui, Designer &d, const World &world, const clq_hsb_range &own, clq_hsb_range now)
{
    const float side = 10.5f * ui.em();
    if (hue_arc(ui, "hue arc", side, d.sweep, now)) set_range(d, own, now, "hue arc");
    ui.same_line();
    if (shade_box(ui, "shade box", side, now)) set_range(d, own, now, "shade box");
    if (pair_field(ui, "hue", now.hue_min_deg, now.hue_max_deg, 360, false)) set_range(d, own, now, "hue");
    if (pair_field(ui, "saturation", now.saturation_min, now.saturation_max, 1, true))
        set_range(d, own, now, "saturation");
    if (pair_field(ui, "brightness", now.brightness_min, now.brightness_max, 1, true))
        set_range(d, own, now, "brightness");
    std::string colour = hex_of(now);
    if (!ui.text_field("one colour", colour)) return;
    const auto typed = range_of_hex(world.context(), colour);
    if (typed) set_range(d, own, *typed, "one colour");
}

// The circle and the box come first: nothing above them grows or shrinks while they are dragged.
void colours(Ui &ui, Designer &d, const World &world, const clq_hsb_range &own)
{
    const std::vector<clq_palette_entry> palette = palette_of(d, own);
    d.entry = std::min(d.entry, palette.size() - 1);
    range(ui, d, world, own, palette[d.entry].range);
    entries(ui, d, own, palette);
    const ZoneColours *zone = chosen_zone(d);
    int space = zone ? static_cast<int>(zone->space) : 0;
    if (ui.choice("spread", space, {"hsb", "oklab"})) set_space(d, own, static_cast<clq_colour_space>(space));
    link(ui, d, own);
    if (!chosen_zone(d)) ui.faint("The class leaves this zone to the template. A change names it.");
    else if (ui.button("leave to template")) forget_zone(d);
}

}  // namespace

void designer_panel(Ui &ui, Model &model, const World &world)
{
    Designer &d = model.designer;
    if (!ui.holds()) d.history.let_go();
    follow_pick(d, model, world);
    changes(ui, d);
    for (const std::string &failure : {d.paint_failure, d.why_not})
        if (!failure.empty()) ui.warning(failure);
    people(ui, d, world);
    Subject subject;
    if (!choose_template(ui, d, world, subject)) return ui.faint("Nothing here has zones to colour.");
    choose_set(ui, d, subject);
    texture(ui, d, subject, world.can_paint());
    choose_zone_by_name(ui, d, subject);
    colours(ui, d, world, subject.zone.range);
    choose_class(ui, d);
    ui.faint(whole(d.history.done()) + " changes to undo, " + whole(d.history.undone()) + " to redo");
    if (d.changed_people > 0)
        ui.faint("The last change reached " + whole(d.changed_people) + " people" +
                 (d.changed_ms < 0 ? "." : " in " + fixed(d.changed_ms, 2) + " ms."));
}

}  // namespace view
