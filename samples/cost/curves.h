// Equation (3) over AverageCost, in the manner of S0's Fig. 6.
#pragma once

#include "samples/charts/lines.h"
#include "samples/cost/readings.h"

namespace cost
{

// A curve for each of fTrack and fCoh 0 or 1: as the paper prints them, and dashed with the counts of its section 4.2;
// also the measured one, with the measured shares, if there is one.
charts::LineChart curves_of(const Scene &scene, const Measured *measured);

}  // namespace cost
