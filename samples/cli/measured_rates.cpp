#include "samples/cli/measured_rates.h"

#include "samples/cli/timed_parts.h"

namespace cli
{

Json measured_rates(scenes::SceneRenderer &scene_renderer, double from_s)
{
    constexpr int updates = 50;
    scene_renderer.update(from_s);
    scenes::check(clq_crowd_reset_bands(scene_renderer.scene().crowd()));
    Times update, draw;
    for (int k = 1; k <= updates; ++k) {
        const Stopwatch updating;
        scene_renderer.update(from_s + k / static_cast<double>(updates));
        update.ms.push_back(updating.ms());
        if (k % 10 != 0) continue;
        draw.ms.push_back(timed_crowd(scene_renderer));
    }
    const clq_crowd_stats stats = scene_renderer.crowd_stats();
    return {{"from_s", from_s},
            {"updates", updates},
            {"updates_hz", updates},
            {"bands", rates(stats)},
            {"update_ms", {{"minimum", update.minimum()}, {"median", update.median()}}},
            {"draw_ms", {{"minimum", draw.minimum()}, {"median", draw.median()}}},
            {"counters", counters(stats)}};
}

}  // namespace cli
