// Check: what may be wrong with the picked individual's character, and its levels beside each other.
#include "samples/view/ground/ground_panels.h"

namespace view
{
namespace
{

void tell_mesh(Ui &ui, const Findings &found)
{
    if (found.warnings.empty()) ui.faint("The loader has no warnings.");
    for (const std::string &warning : found.warnings) ui.warning(warning);
    if (found.open_edges == 0) ui.row("open edges", "none");
    else ui.row("open edges", whole(found.open_edges));
    ui.row("influences", "at most " + std::to_string(found.most_influences) + " a vertex");
    if (found.many_influences > 0)
        ui.warning(whole(found.many_influences) + " vertices follow more than four joints: they cost more");
}

void tell_zones(Ui &ui, const Findings &found)
{
    ui.text("zones: share of the visible surface");
    for (const Findings::Zone &zone : found.zones) {
        const std::string words = zone.name + ": " + fixed(100 * zone.share, 1) + " %";
        if (!(zone.share > 0)) ui.warning(words + ", nowhere to be seen");
        else if (zone.gone_from_m >= 0) ui.warning(words + ", gone from " + fixed(zone.gone_from_m, 0) + " m");
        else ui.faint(words);
    }
}

void tell_levels(Ui &ui, const Findings &found)
{
    if (!found.no_levels.empty()) ui.faint(found.no_levels);
    ui.text("levels: from, triangles, error in motion");
    for (size_t i = 0; i < found.levels.size(); ++i) {
        const Findings::Level &level = found.levels[i];
        const std::string measured = level.error_mm < 0 ? "its own"
                                                        : fixed(level.error_mm, 1) + " mm, zones " +
                                                              fixed(100 * level.zone_area_error, 1) + " %";
        ui.faint(std::to_string(i) + ": " + fixed(static_cast<double>(level.from_m), 1) + " m, " +
                 whole(level.triangles) + ", " + measured);
        if (level.open_edges > 0) ui.warning("  " + whole(level.open_edges) + " more open edges");
    }
}

}  // namespace

void check_panel(Ui &ui, Model &model, const World &world, const clq_template *tmpl)
{
    const Findings *found = world.findings(tmpl);
    if (!found) {
        ui.faint("Makes levels of detail and measures them; this takes some seconds.");
        if (ui.button("examine")) model.ground.examine = true;
        return;
    }
    tell_mesh(ui, *found);
    tell_zones(ui, *found);
    tell_levels(ui, *found);
    ui.toggle("levels in a row", model.ground.level_row);
}

}  // namespace view
