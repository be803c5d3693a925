// Costs of operations in FMULT, the time of one multiplication (S0 6): Table 6, and equations (1) to (3) on top of it.
#pragma once

#include "samples/cost/operations.h"

namespace cost
{

// S0 6.2.2. Tracking: the share of matrix products that the CPU must know. Coherence: the share of frames in which a
// matrix changes.
struct Shares {
    double track, coherence;
};

// A cost that depends on the shares: both x fTrack x fCoh + track x fTrack + coherence x fCoh + constant.
struct Polynomial {
    double both = 0, track = 0, coherence = 0, constant = 0;

    double at(const Shares &s) const
    {
        return both * s.track * s.coherence + track * s.track + coherence * s.coherence + constant;
    }
};
Polynomial operator*(double times, const Polynomial &p);
Polynomial operator+(const Polynomial &a, const Polynomial &b);

// Table 6. For NO_01 to NO_03 the values of the degrees of freedom cost `values` times AverageCost (CO_01a to CO_03a)
// and the matrices `one` (CO_01b to CO_03b); the other operations cost `one`.
struct UnitCosts {
    std::array<double, 3> values;
    std::array<Polynomial, operation_count> one;
};
const UnitCosts &table_6(Processing processing);

// Equation (2): behaviour is in AverageCosts, management in FMULT.
struct Cost {
    double behaviour;       // BMC
    Polynomial management;  // SGMC

    double global(double average_cost, const Shares &shares) const
    {
        return behaviour * average_cost + management.at(shares);
    }
};
Cost cost_of(const Counts &counts, const UnitCosts &units);

// The part of SGMC that does not depend on the shares because it involves no matrix: spheres, tests and distances.
double cost_without_matrices(const Counts &counts, const UnitCosts &units);

// Equations (1) and (3).
double improvement(const Cost &traditional, const Cost &actor, double average_cost, const Shares &shares);
// The limit of the improvement as AverageCost grows.
double improvement_limit(const Cost &traditional, const Cost &actor);

}  // namespace cost
