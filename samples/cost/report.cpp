#include "samples/cost/report.h"

#include <iterator>

#include <nlohmann/json.hpp>

#include "samples/cost/measured.h"

namespace cost
{
namespace
{

using Json = nlohmann::ordered_json;

constexpr const char *heading = "Where the paper's numbers differ from its own tables, and where they agree";

Json json_of(const Counts &counts)
{
    Json json;
    for (size_t i = 0; i < operation_count; ++i) json[name_of(static_cast<Operation>(i))] = counts[i];
    return json;
}

Json json_of(const Cost &cost)
{
    const Polynomial &p = cost.management;
    return {{"behaviour", cost.behaviour},
            {"management",
             {{"fTrack_fCoh", p.both}, {"fTrack", p.track}, {"fCoh", p.coherence}, {"constant", p.constant}}}};
}

Json json_of(const Reading &reading)
{
    Json json = {
        {"key", reading.key},
        {"is", reading.why},
        {"counts", {{"traditional", json_of(reading.traditional_counts)}, {"actor", json_of(reading.actor_counts)}}},
        {"constant", reading.constant},
        {"traditional", json_of(reading.traditional)},
        {"actor", json_of(reading.actor)},
        {"limit", reading.limit()},
        {"improvement", Json::array()}};
    std::vector<Shares> all(corner_shares.begin(), corner_shares.end());
    if (reading.measured) all.push_back(*reading.measured);
    for (const Shares &shares : all)
        for (const double average : average_costs)
            json["improvement"].push_back({{"fTrack", shares.track},
                                           {"fCoh", shares.coherence},
                                           {"AverageCost", average},
                                           {"factor", reading.improvement(average, shares)}});
    return json;
}

// NO_01 was counted after levels of detail, and Table 6 halves its price once more for them.
std::string remark_of(const Measured &measured, const Reading &reading)
{
    const double full = measured.actor[no_01] + measured.actor[no_02] + measured.actor[no_03];
    return "Measured: " + measured.note + ", " + text_of(measured.shares) + ". The improvement is " +
           text_of(Figure{reading.improvement(0, measured.shares), 1}) + " at AverageCost 0 and tends to " +
           text_of(Figure{reading.limit(), 1}) + ", or to " + text_of(Figure{reading.traditional.behaviour / full, 1}) +
           " with CO_01a and CO_03a at a whole AverageCost, because the counts already leave out what levels of detail "
           "drop.";
}

void append(std::vector<Table> &to, std::vector<Table> tables)
{
    to.insert(to.end(), std::make_move_iterator(tables.begin()), std::make_move_iterator(tables.end()));
}

}  // namespace

Report report_of(const Scene &scene, const Measured *measured)
{
    const std::vector<Reading> readings = readings_of(scene, measured);
    Report report = {tables_of_scene(scene), remarks_of(scene)};
    append(report.tables, tables_of_counts(readings));
    append(report.tables, tables_of_costs(readings));
    if (measured) report.remarks.push_back(remark_of(*measured, readings.back()));
    return report;
}

std::string text_of(const Report &report)
{
    std::string text;
    for (const Table &table : report.tables) text += text_of(table) + "\n";
    text += std::string(heading) + "\n";
    for (const std::string &remark : report.remarks) text += "  - " + wrapped(remark, 114, "    ") + "\n";
    return text;
}

std::string markdown_of(const Report &report)
{
    std::string text;
    for (const Table &table : report.tables) text += markdown_of(table) + "\n";
    text += std::string(heading) + ":\n\n";
    for (const std::string &remark : report.remarks) text += "- " + remark + "\n";
    return text;
}

Json json_of(const Report &report, const std::vector<Reading> &readings)
{
    Json json = {{"tables", Json::array()}, {"remarks", report.remarks}, {"readings", Json::array()}};
    for (const Table &table : report.tables) json["tables"].push_back(json_of(table));
    for (const Reading &reading : readings) json["readings"].push_back(json_of(reading));
    return json;
}

}  // namespace cost
