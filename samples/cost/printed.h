// The results that S0 prints although they could be computed: for comparison with computed results, and for the
// reading "as printed" only.
#pragma once

#include "samples/cost/fmult.h"

namespace cost::printed
{

// Table 5, columns 4 and 5.
constexpr Counts traditional = {4000, 100, 100, 8200, 460, 4100};
constexpr Counts actor = {400, 100, 30, 160, 200, 100};

// Section 6.2.1.
constexpr double traditional_behaviour = 4200, actor_behaviour = 315;

// Section 6.2.2: the constant of the first form of Act_ProcSGMC, and the second form.
constexpr double traditional_management = 4206240, constant = 23100;
constexpr Polynomial actor_management = {11600, 21200, 12350, 35290};

// Section 6.2.3: the improvement for AverageCost below 100, and in the worst case.
constexpr double least = 50, most = 120, worst = 13, common_cost = 100;

// Section 4.2, of a typical scene: shares of the actors that the first cull removes, and the second.
constexpr double typical_first = 0.7, typical_second = 0.1;

}  // namespace cost::printed
