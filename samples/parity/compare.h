// Compares two results by every measure for which both have the arrays.
#pragma once

#include "samples/parity/capture.h"
#include "samples/parity/ids.h"
#include "samples/parity/measures.h"

namespace parity
{

struct NotCompared {
    std::string group, why;  // "depth", "the result has no depth.npy"
};

struct Comparison {
    std::vector<Measure> measures;
    std::vector<NotCompared> not_compared;
    Map<Mark> actor_marks, zone_marks;  // empty where ids were not compared
    Map<float> flip;                    // the same for colours
};

// Throws Unreadable if the two cannot be of one scene: different picture sizes, different times, or no array in
// common.
Comparison compare(const Capture &reference, const Capture &result, double pixels_per_degree);

}  // namespace parity
