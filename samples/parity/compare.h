// Two results beside each other: every measure that both have the arrays for.
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
    Map<float> flip;                    // likewise of colours
};

// Throws Unreadable where the two cannot be of one scene: other sizes of the picture, another moment, or nothing in common.
Comparison compare(const Capture &reference, const Capture &result, double pixels_per_degree);

}  // namespace parity
