// The output of `claque cost`: S0's Tables 1 to 6 and equation (3), computed, beside the paper's printed values, with
// sentences where the two differ.
#pragma once

#include "samples/cost/readings.h"
#include "samples/cost/table.h"

namespace cost
{

struct Report {
    std::vector<Table> tables;
    std::vector<std::string> remarks;
};

// The AverageCosts of the tables of equation (3), and the shares of its curves: fTrack and fCoh 0 or 1.
extern const std::array<double, 8> average_costs;
extern const std::array<Shares, 4> corner_shares;
std::string text_of(const Shares &shares);

Report report_of(const Scene &scene, const Measured *measured);

// Parts of the report.
std::vector<Table> tables_of_scene(const Scene &scene);                     // 1 to 4
std::vector<Table> tables_of_counts(const std::vector<Reading> &readings);  // 5, 6
std::vector<Table> tables_of_costs(const std::vector<Reading> &readings);   // equations (2) and (3)
std::vector<std::string> remarks_of(const Scene &scene);

std::string text_of(const Polynomial &polynomial);
std::string text_of(const Report &report);
std::string markdown_of(const Report &report);
nlohmann::ordered_json json_of(const Report &report, const std::vector<Reading> &readings);

}  // namespace cost
