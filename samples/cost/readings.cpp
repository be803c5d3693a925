#include "samples/cost/readings.h"

#include "samples/cost/measured.h"
#include "samples/cost/printed.h"

namespace cost
{
namespace
{

Reading counted(const char *key, const char *name, const char *why, const Counts &traditional, const Counts &actor)
{
    return {key,
            name,
            why,
            traditional,
            actor,
            cost_of(traditional, table_6(Processing::traditional)),
            cost_of(actor, table_6(Processing::actor)),
            cost_without_matrices(actor, table_6(Processing::actor)),
            std::nullopt,
            false};
}

}  // namespace

Reading as_printed()
{
    return {"printed",
            "printed",
            "equation (3) with the constants that the paper prints",
            printed::traditional,
            printed::actor,
            {printed::traditional_behaviour, {0, 0, 0, printed::traditional_management}},
            {printed::actor_behaviour, printed::actor_management},
            printed::constant,
            std::nullopt,
            false};
}

Reading from_printed_counts()
{
    return counted("table_5", "Table 5", "the numbers that Table 5 prints, with the costs of Table 6",
                   printed::traditional, printed::actor);
}

Reading from_formulas(const Scene &scene)
{
    const Factors factors = factors_of(scene);
    return counted("formulas", "formulas", "the formulas of Table 5 with the factors of Table 4, and Table 6",
                   counts_of_table_5(factors, Processing::traditional), counts_of_table_5(factors, Processing::actor));
}

Reading by_order_of_work(const Scene &scene)
{
    return counted("section_4_2", "section 4.2", "the scene of Table 2, processed in the order of section 4.2",
                   counts_by_order_of_work(scene, Processing::traditional),
                   counts_by_order_of_work(scene, Processing::actor));
}

Reading as_measured(const Measured &measured, const Scene &scene)
{
    const bool both = measured.traditional.has_value();
    Reading reading =
        counted("measured", "measured",
                both ? "what a run of the library counted, in both modes"
                     : "what a run of the library counted, against section 4.2's traditional processing",
                both ? *measured.traditional : counts_by_order_of_work(scene, Processing::traditional), measured.actor);
    reading.measured = measured.shares;
    reading.traditional_measured = both;
    return reading;
}

std::vector<Reading> readings_of(const Scene &scene, const Measured *measured)
{
    std::vector<Reading> readings = {as_printed(), from_printed_counts(), from_formulas(scene),
                                     by_order_of_work(scene)};
    if (measured) readings.push_back(as_measured(*measured, scene));
    return readings;
}

}  // namespace cost
