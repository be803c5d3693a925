// Tables 5 and 6: numbers of operations, and their costs.
#include "samples/cost/report.h"

namespace cost
{
namespace
{

// One column for each reading. The first two have the same counts, so only one of them is shown.
Table table_5_of(Processing processing, const std::vector<Reading> &all)
{
    const bool actor = processing == Processing::actor;
    Table t = {std::string("Table 5. Operations in a frame, ") + (actor ? "actor" : "traditional") + " processing",
               {""},
               {},
               {}};
    std::vector<Reading> readings;
    for (size_t r = 1; r < all.size(); ++r)
        if (actor || !all[r].measured || all[r].traditional_measured) readings.push_back(all[r]);
    for (const Reading &reading : readings) t.columns.push_back(reading.key == "table_5" ? "printed" : reading.name);
    t.columns.emplace_back("the paper's formula");
    for (size_t i = 0; i < operation_count; ++i) {
        const Operation operation = static_cast<Operation>(i);
        std::vector<Cell> row = {name_of(operation)};
        for (const Reading &reading : readings)
            row.emplace_back(figure((actor ? reading.actor_counts : reading.traditional_counts)[i]));
        row.emplace_back(table_5(operation, processing).words);
        t.rows.push_back(row);
    }
    return t;
}

Table order_of_work()
{
    Table t = {"Counts for the scene of Table 2 in the order of work of section 4.2",
               {"", "processing", "operations", "because"},
               {},
               {}};
    for (size_t i = 0; i < operation_count; ++i)
        for (const Processing p : {Processing::traditional, Processing::actor}) {
            const Operation operation = static_cast<Operation>(i);
            const SceneFormula &formula = by_order_of_work(operation, p);
            if (operation == no_04b && p == Processing::traditional) continue;  // the same row
            t.rows.push_back({name_of(operation),
                              operation == no_04b      ? "both"
                              : p == Processing::actor ? "actor"
                                                       : "traditional",
                              formula.words, formula.why});
        }
    return t;
}

Table table_6_shown()
{
    Table t = {"Table 6. Costs in FMULT", {"", "traditional", "actor"}, {}, {}};
    const UnitCosts &traditional = table_6(Processing::traditional), &actor = table_6(Processing::actor);
    const auto average = [](double share) {
        return share == 1 ? std::string("AverageCost") : text_of(figure(share)) + " AverageCost";
    };
    for (size_t i = 0; i < operation_count; ++i) {
        const std::string name = "C" + std::string(name_of(static_cast<Operation>(i))).substr(1);
        if (i < traditional.values.size())
            t.rows.push_back({name + "a", average(traditional.values[i]), average(actor.values[i])});
        t.rows.push_back(
            {i < traditional.values.size() ? name + "b" : name, text_of(traditional.one[i]), text_of(actor.one[i])});
    }
    t.notes = {
        "1 FMULT is the time of a multiplication or an addition; a division is 5, a square root 7, a 4 x 4 product "
        "on graphics hardware 10."};
    return t;
}

}  // namespace

std::string text_of(const Polynomial &p)
{
    std::string text;
    const auto term = [&](double factor, const char *of) {
        if (factor == 0 && *of) return;
        text += (text.empty() ? "" : " + ") + text_of(figure(factor)) + (*of ? " " : "") + of;
    };
    term(p.both, "fTrack fCoh");
    term(p.track, "fTrack");
    term(p.coherence, "fCoh");
    term(p.constant, "");
    return text;
}

std::vector<Table> tables_of_counts(const std::vector<Reading> &readings)
{
    return {table_5_of(Processing::traditional, readings), table_5_of(Processing::actor, readings), order_of_work(),
            table_6_shown()};
}

}  // namespace cost
