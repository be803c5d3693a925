// A comparison as JSON, for scripts.
#include <cmath>

#include <nlohmann/json.hpp>

#include "samples/parity/report.h"

namespace parity
{
namespace
{

using OrderedJson = nlohmann::ordered_json;

// JSON has no infinity, which is the PSNR of equal pictures.
OrderedJson number(double value)
{
    if (std::isfinite(value)) return value;
    return std::isnan(value) ? "not a number" : value > 0 ? "infinite" : "-infinite";
}

OrderedJson side(const Capture &c) { return {{"folder", c.folder}, {"renderer", c.renderer}, {"scene", c.scene}}; }

OrderedJson measures(const Report &report)
{
    OrderedJson out = OrderedJson::object();
    for (const Measure &m : report.comparison.measures) {
        OrderedJson entry = {{"value", number(m.value)}};
        if (!m.unit.empty()) entry["unit"] = m.unit;
        if (!m.where.empty()) entry["where"] = m.where;
        if (const Check *check = report.verdict.find(m.name)) {
            entry[check->at_least ? "at_least" : "at_most"] = number(check->bound);
            entry["kept"] = check->kept;
        }
        out[m.name] = entry;
    }
    return out;
}

OrderedJson groups(const std::vector<NotCompared> &list)
{
    OrderedJson out = OrderedJson::array();
    for (const NotCompared &n : list) out.push_back({{"group", n.group}, {"why", n.why}});
    return out;
}

}  // namespace

std::string report_json(const Report &report)
{
    const OrderedJson json = {{"format", "claque-parity-report"},
                              {"version", 1},
                              {"verdict", report.verdict.pass ? "pass" : "fail"},
                              {"tolerance", report.verdict.tolerance},
                              {"reference", side(report.reference)},
                              {"result", side(report.result)},
                              {"width", report.reference.width},
                              {"height", report.reference.height},
                              {"time_s", report.reference.time_s},
                              {"measures", measures(report)},
                              {"not_compared", groups(report.comparison.not_compared)},
                              {"lacking", groups(report.verdict.lacking)}};
    return json.dump(2, ' ', false, OrderedJson::error_handler_t::replace) + "\n";
}

}  // namespace parity
