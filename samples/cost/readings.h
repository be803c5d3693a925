// The ways to fill in equation (3): as S0 prints it, from its own tables and formulas, from the scene of Table 2
// processed by S0 4.2, and from the counts of a run of the library.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "samples/cost/fmult.h"

namespace cost
{

struct Measured;

struct Reading {
    std::string key, name, why;
    Counts traditional_counts, actor_counts;
    Cost traditional, actor;
    double constant;                 // of SGMC: the part without matrices
    std::optional<Shares> measured;  // the shares that belong to the counts, if a run counted them
    bool traditional_measured = false;

    double improvement(double average_cost, const Shares &shares) const
    {
        return cost::improvement(traditional, actor, average_cost, shares);
    }
    double limit() const { return improvement_limit(traditional, actor); }
};

Reading as_printed();                          // S0's equation (3)
Reading from_printed_counts();                 // Table 5's numbers with Table 6's costs
Reading from_formulas(const Scene &scene);     // Table 5's formulas with Table 6's costs
Reading by_order_of_work(const Scene &scene);  // the scene of Table 2 under section 4.2
Reading as_measured(const Measured &measured, const Scene &scene);

// All of them; the measured one only if there is one.
std::vector<Reading> readings_of(const Scene &scene, const Measured *measured);

}  // namespace cost
