// Why a frame is slow: what it cost and counted, and switches whose effect the plot shows.
#include <algorithm>

#include "samples/view/panels.h"

namespace view
{
namespace
{

std::string part(uint64_t some, uint64_t all)
{
    return whole(some) + (all > 0 ? " (" + std::to_string(some * 100 / all) + " %)" : "");
}

void times(Ui &ui, const Model &model)
{
    const FrameCost &cost = model.cost;
    if (cost.update_ms < 0) return ui.faint("Times are not measured in scripts without `measured`.");
    ui.row("place", milliseconds(cost.place_ms));
    ui.row("update", milliseconds(cost.update_ms));
    ui.row("ground", milliseconds(cost.surroundings_ms));
    ui.row("crowd", milliseconds(cost.crowd_ms));
    ui.row("panels", milliseconds(cost.interface_ms));
    std::vector<float> values;
    for (const FrameCost &one : model.history)
        values.push_back(static_cast<float>(one.place_ms + one.update_ms + one.crowd_ms));
    const double worst = values.empty() ? 0 : static_cast<double>(*std::max_element(values.begin(), values.end()));
    ui.plot("people's milliseconds", values,
            "people, " + std::to_string(values.size()) + " frames, at most " + milliseconds(worst));
}

void counts(Ui &ui, const Model &model)
{
    const clq_crowd_stats &crowd = model.cost.crowd;
    const clq_draw_stats &drawn = model.cost.drawn;
    ui.row("in view", whole(crowd.visible) + " of " + whole(crowd.actor_count));
    ui.row("passed", whole(crowd.passed_refpoint) + " reference, " + whole(crowd.passed_sklsroot) + " root");
    ui.row("due", whole(crowd.due));
    ui.row("skinned", part(crowd.skinned, crowd.visible));
    ui.row("cached", part(crowd.palette_served, crowd.visible) + " palettes");
    ui.row("", part(crowd.vertices_served, crowd.visible) + " vertices");
    ui.row("draw calls", whole(drawn.draws));
    ui.row("triangles", whole(drawn.triangles));
    ui.row("vertices", whole(drawn.vertices));
    ui.row("caches", memory(crowd.cache_bytes) + " of " + memory(crowd.cache_budget_bytes));
    ui.row("actors", memory(crowd.actor_bytes));
    ui.row("frame", memory(crowd.frame_bytes) + ", list " + memory(model.cost.seen.bytes));
    std::vector<float> due;
    for (const FrameCost &one : model.history) due.push_back(static_cast<float>(one.crowd.due));
    ui.plot("due people", due, "people due, " + std::to_string(due.size()) + " frames");
}

void bands(Ui &ui, const clq_crowd_stats &crowd)
{
    ui.text("poses a second, by distance");
    for (const clq_distance_band &band : crowd.bands) {
        if (band.actor_frames == 0 || !(band.seconds > 0)) continue;
        const bool last = &band == &crowd.bands[CLQ_DISTANCE_BAND_COUNT - 1];
        ui.faint(fixed(static_cast<double>(band.distance_min_m), 0) +
                 (last ? " m and more: " : " to " + fixed(static_cast<double>(band.distance_max_m), 0) + " m: ") +
                 fixed(static_cast<double>(band.animated) / band.seconds, 1));
    }
}

}  // namespace

void frame_panel(Ui &ui, Model &model, const World &world)
{
    Switches &switches = model.switches;
    ui.choice("strategy", switches.strategy, {"fused", "binned", "per zone"});
    ui.choice("caches", switches.cache, {"full", "palettes", "none", "key-poses"});
    ui.choice("culling", switches.cull, {"three phases", "last"});
    ui.choice("format", switches.format, {"float", "packed"});
    ui.choice("levels", switches.levels, {"off", "on", "early"});
    int threads = switches.threads >= 4 ? 2 : switches.threads - 1;
    if (ui.choice("threads", threads, {"1", "2", "4"})) switches.threads = threads == 2 ? 4 : threads + 1;
    if (ui.button("count anew")) {
        clq_crowd_reset_bands(world.crowd());
        model.history.clear();
    }
    times(ui, model);
    counts(ui, model);
    bands(ui, model.cost.crowd);
}

}  // namespace view
