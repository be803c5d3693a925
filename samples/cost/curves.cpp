#include "samples/cost/curves.h"

#include "samples/cost/measured.h"
#include "samples/cost/report.h"

namespace cost
{
namespace
{

constexpr double most_average = 1000, step = 5;

charts::Series curve(const Reading &reading, const Shares &shares, size_t colour, charts::Dash dash)
{
    charts::Series series = {reading.name + ": " + text_of(shares), {}, colour, dash, charts::Series::Dots::never};
    for (double average = 0; average <= most_average; average += step)
        series.points.push_back({average, reading.improvement(average, shares)});
    return series;
}

}  // namespace

charts::LineChart curves_of(const Scene &scene, const Measured *measured)
{
    charts::LineChart chart;
    const Reading printed = as_printed(), real = by_order_of_work(scene);
    chart.title = "How much less an actor pipeline costs than a traditional scenegraph";
    chart.subtitle = "S0's equation (3) for its scene of " + std::to_string(scene.actors()) +
                     " actors, after its Fig. 6: solid as printed, dashed with the actors that pass by its section 4.2";
    chart.x = {"AverageCost: behaviour of one Skeleton node (FMULT)", charts::Scale::linear, 0.0, most_average};
    chart.y = {"improvement factor", charts::Scale::linear, 0.0, {}};
    for (size_t i = 0; i < corner_shares.size(); ++i)
        chart.series.push_back(curve(printed, corner_shares[i], i + 1, charts::Dash::solid));
    for (size_t i = 0; i < corner_shares.size(); ++i)
        chart.series.push_back(curve(real, corner_shares[i], i + 1, charts::Dash::dashed));
    chart.note = "The more a node's behaviour costs, the less the rest matters: printed curves tend to " +
                 text_of(Figure{printed.limit(), 1}) + ", dashed ones to " + text_of(Figure{real.limit(), 1}) + ".";
    chart.note +=
        " fTrack is the share of matrix products that the CPU has to know, fCoh the share of frames in which a matrix "
        "changes.";
    if (measured) {
        chart.series.push_back(curve(as_measured(*measured, scene), measured->shares, 5, charts::Dash::dotted));
        chart.note += " Measured: " + measured->note + ".";
    }
    return chart;
}

}  // namespace cost
