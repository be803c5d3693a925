// Equations (2) and (3) for each reading.
#include "samples/cost/report.h"

namespace cost
{

const std::array<double, 8> average_costs = {0, 10, 50, 100, 200, 500, 1000, 10000};
const std::array<Shares, 4> corner_shares = {{{0, 0}, {0, 1}, {1, 0}, {1, 1}}};

std::string text_of(const Shares &s)
{
    const auto share = [](double value) { return text_of(figure(value)); };
    return "fTrack " + share(s.track) + ", fCoh " + share(s.coherence);
}

namespace
{

Table global_costs(const std::vector<Reading> &readings)
{
    Table t = {"Equation (2). A frame's cost in FMULT: behaviour (AverageCosts) + scene graph management",
               {"reading", "processing", "BMC", "without matrices", "SGMC"},
               {},
               {}};
    for (const Reading &r : readings) {
        t.rows.push_back(
            {r.name, "traditional", figure(r.traditional.behaviour), "", text_of(r.traditional.management)});
        t.rows.push_back({"", "actor", figure(r.actor.behaviour), figure(r.constant), text_of(r.actor.management)});
    }
    for (const Reading &r : readings) t.notes.push_back(r.name + ": " + r.why + ".");
    return t;
}

Table equation_3(const Reading &reading)
{
    std::vector<Shares> columns(corner_shares.begin(), corner_shares.end());
    if (reading.measured) columns.push_back(*reading.measured);
    Table t = {
        "Equation (3), " + reading.name + ". Improvement: traditional cost / actor cost", {"AverageCost"}, {}, {}};
    for (const Shares &shares : columns) t.columns.push_back(text_of(shares));
    for (const double average : average_costs) {
        std::vector<Cell> row = {figure(average)};
        for (const Shares &shares : columns) row.emplace_back(Figure{reading.improvement(average, shares), 1});
        t.rows.push_back(row);
    }
    std::vector<Cell> last = {"without end"};
    for (size_t c = 0; c < columns.size(); ++c) last.emplace_back(Figure{reading.limit(), 1});
    t.rows.push_back(last);
    return t;
}

}  // namespace

std::vector<Table> tables_of_costs(const std::vector<Reading> &readings)
{
    std::vector<Table> tables = {global_costs(readings)};
    for (const Reading &reading : readings) tables.push_back(equation_3(reading));
    return tables;
}

}  // namespace cost
