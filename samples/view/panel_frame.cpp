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

// The last ten seconds in equal parts of time: the most of each, and what was before where a part has no frame.
template <class Value>
std::vector<float> plotted(const Model &model, const Value &value)
{
    constexpr size_t parts = 125;
    std::vector<float> out(parts, -1);
    for (const FrameCost &one : model.history) {
        const double share = 1 - (model.real_s - one.at_s) / history_s;
        float &part = out[std::min(parts - 1, static_cast<size_t>(std::max(0.0, share) * parts))];
        part = std::max(part, static_cast<float>(value(one)));
    }
    float last = 0;
    for (float &part : out) last = part = part < 0 ? last : part;
    return out;
}

std::vector<float> switch_marks(const Model &model)
{
    std::vector<float> marks;
    for (const Switched &one : model.switched)
        marks.push_back(static_cast<float>(1 - (model.real_s - one.at_s) / history_s));
    return marks;
}

void step_rows(Ui &ui, const clq_update_times &steps)
{
    if (!steps.measured) return;
    const std::pair<const char *, double> rows[] = {{"  cull", steps.cull_s},        {"  choose", steps.choose_s},
                                                    {"  behave", steps.behave_s},    {"  animate", steps.animate_s},
                                                    {"  parts", steps.cull_parts_s}, {"  skin", steps.skin_s},
                                                    {"  list", steps.list_s}};
    for (const auto &[name, seconds] : rows) ui.row(name, milliseconds(seconds * 1000));
}

void times(Ui &ui, const Model &model)
{
    const FrameCost &cost = model.cost;
    if (cost.update_ms < 0) return ui.faint("Times are not measured in scripts without `measured`.");
    ui.row("place", milliseconds(cost.place_ms));
    ui.row("update", milliseconds(cost.update_ms));
    step_rows(ui, cost.steps);
    ui.row("ground", milliseconds(cost.surroundings_ms));
    ui.row("crowd", milliseconds(cost.crowd_ms));
    ui.row("panels", milliseconds(cost.interface_ms) + ", in GL " + milliseconds(cost.interface_gl_ms));
    const std::vector<float> values = plotted(model, people_ms);
    const double worst = static_cast<double>(*std::max_element(values.begin(), values.end()));
    ui.plot("people's milliseconds", values, "people, last 10 s, at most " + milliseconds(worst), switch_marks(model));
}

// The mean over the frames between two times, of those that were measured.
template <class Value>
double mean(const Model &model, double from_s, double to_s, const Value &value)
{
    double sum = 0;
    int count = 0;
    for (const FrameCost &one : model.history)
        if (one.at_s > from_s && one.at_s <= to_s && value(one) >= 0) sum += value(one), ++count;
    return count > 0 ? sum / count : 0;
}

// What the last switch changed.
void effect(Ui &ui, const Model &model)
{
    if (model.switched.empty()) return;
    const Switched &last = model.switched.back();
    const double before_s = model.switched.size() > 1 ? model.switched[model.switched.size() - 2].at_s : -1;
    const auto compared = [&](const auto &value, int digits) {
        return fixed(mean(model, before_s, last.at_s, value), digits) + " before, " +
               fixed(mean(model, last.at_s, model.real_s, value), digits) + " since";
    };
    ui.text(last.words + ", " + fixed(model.real_s - last.at_s, 1) + " s ago");
    if (model.cost.update_ms >= 0) ui.row("people, ms", compared(people_ms, 2));
    ui.row("skinned", compared([](const FrameCost &one) { return static_cast<double>(one.crowd.skinned); }, 1));
    ui.row("triangles", compared([](const FrameCost &one) { return static_cast<double>(one.drawn.triangles); }, 0));
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
    const std::vector<float> due = plotted(model, [](const FrameCost &one) { return one.crowd.due; });
    ui.plot("due people", due, "people due, last 10 s", switch_marks(model));
}

// How many were in view at each distance in the last frame, how many of them were posed, and how often one is.
void bands(Ui &ui, const Model &model)
{
    ui.text("posed in this frame, by distance");
    const size_t frames = model.history.size();
    for (size_t k = 0; k < CLQ_DISTANCE_BAND_COUNT; ++k) {
        const clq_distance_band &band = model.cost.crowd.bands[k];
        if (band.actor_frames == 0) continue;
        clq_distance_band before = {};
        if (frames > 1) before = model.history[frames - 2].crowd.bands[k];
        if (before.actor_frames > band.actor_frames) before = {};  // counted anew since
        const bool last = k == CLQ_DISTANCE_BAND_COUNT - 1;
        ui.faint(
            fixed(static_cast<double>(band.distance_min_m), 0) +
            (last ? " m and more: " : " to " + fixed(static_cast<double>(band.distance_max_m), 0) + " m: ") +
            whole(band.animated - before.animated) + " of " + whole(band.actor_frames - before.actor_frames) +
            (band.seconds > 0 ? ", " + fixed(static_cast<double>(band.animated) / band.seconds, 1) + " poses/s" : ""));
    }
}

void use(Model &model, const char *name, const std::vector<std::string> &items, int chosen)
{
    model.switched.push_back({model.real_s, std::string(name) + ": " + items[static_cast<size_t>(chosen)]});
}

void switch_rows(Ui &ui, Model &model)
{
    Switches &switches = model.switches;
    const int before = switches.threads >= 4 ? 2 : switches.threads - 1;
    int threads = before;
    struct Row {
        const char *name;
        int &value;
        std::vector<std::string> items;
    };
    const Row rows[] = {{"strategy", switches.strategy, {"fused", "binned", "per zone"}},
                        {"close textures", switches.close_textures, {"off", "on"}},
                        {"caches", switches.cache, {"full", "palettes", "none", "key-poses"}},
                        {"culling", switches.cull, {"three phases", "last"}},
                        {"format", switches.format, {"float", "packed"}},
                        {"levels", switches.levels, {"off", "on", "early"}},
                        {"threads", threads, {"1", "2", "4"}}};
    for (const Row &row : rows)
        if (ui.choice(row.name, row.value, row.items)) use(model, row.name, row.items, row.value);
    if (threads != before) switches.threads = threads == 2 ? 4 : threads + 1;
}

}  // namespace

void frame_panel(Ui &ui, Model &model, const World &world)
{
    switch_rows(ui, model);
    if (ui.button("count anew")) {
        clq_crowd_reset_bands(world.crowd());
        model.history.clear();
        model.switched.clear();
    }
    effect(ui, model);
    times(ui, model);
    counts(ui, model);
    bands(ui, model);
}

}  // namespace view
