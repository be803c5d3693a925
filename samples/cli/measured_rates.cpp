#include "samples/cli/measured_rates.h"

#include "samples/cli/interrupt.h"
#include "samples/cli/stopwatch.h"

namespace cli
{

Json measured_rates(scenes::Stage &stage, double from_s)
{
    constexpr int updates = 50;
    stage.update(from_s);
    scenes::check(clq_crowd_reset_bands(stage.scene().crowd()));
    Times update, draw;
    for (int k = 1; k <= updates; ++k) {
        stop_if_asked();
        const Stopwatch updating;
        stage.update(from_s + k / static_cast<double>(updates));
        update.ms.push_back(updating.ms());
        if (k % 10 != 0) continue;
        stage.draw_setting();
        stage.gl().Finish();
        stage.draw_shadows();
        const Stopwatch drawing;
        stage.draw_crowd();
        draw.ms.push_back(drawing.ms());
    }
    const clq_crowd_stats stats = stage.crowd_stats();
    return {{"from_s", from_s},
            {"updates", updates},
            {"updates_hz", updates},
            {"bands", rates(stats)},
            {"update_ms", {{"minimum", update.minimum()}, {"median", update.median()}}},
            {"draw_ms", {{"minimum", draw.minimum()}, {"median", draw.median()}}},
            {"counters", counters(stats)}};
}

}  // namespace cli
