#include "samples/cost/fmult.h"

namespace cost
{

Polynomial operator*(double times, const Polynomial &p)
{
    return {times * p.both, times * p.track, times * p.coherence, times * p.constant};
}

Polynomial operator+(const Polynomial &a, const Polynomial &b)
{
    return {a.both + b.both, a.track + b.track, a.coherence + b.coherence, a.constant + b.constant};
}

const UnitCosts &table_6(Processing processing)
{
    static constexpr Polynomial sphere = {0, 0, 0, 50}, test = {0, 0, 0, 64}, distance = {0, 0, 0, 8};
    static constexpr UnitCosts traditional = {
        {1, 1, 1}, {{{0, 0, 0, 908}, {0, 0, 0, 454}, {0, 0, 0, 566}, sphere, test, distance}}};
    static constexpr UnitCosts actor = {{0.5, 1, 0.5},
                                        {{{29, 53, 19, 10}, {0, 0, 22, 63}, {0, 0, 85, 63}, sphere, test, distance}}};
    return processing == Processing::actor ? actor : traditional;
}

Cost cost_of(const Counts &counts, const UnitCosts &units)
{
    Cost cost = {0, {}};
    for (size_t i = 0; i < units.values.size(); ++i) cost.behaviour += counts[i] * units.values[i];
    for (size_t i = 0; i < operation_count; ++i) cost.management = cost.management + counts[i] * units.one[i];
    return cost;
}

double cost_without_matrices(const Counts &counts, const UnitCosts &units)
{
    double cost = 0;
    for (const Operation i : {no_04a, no_04b, no_05}) cost += counts[i] * units.one[i].constant;
    return cost;
}

double improvement(const Cost &traditional, const Cost &actor, double average_cost, const Shares &shares)
{
    return traditional.global(average_cost, shares) / actor.global(average_cost, shares);
}

double improvement_limit(const Cost &traditional, const Cost &actor) { return traditional.behaviour / actor.behaviour; }

}  // namespace cost
