// A call of the C API with each of its allocations failing in turn.
#pragma once

#include <set>

#include "tests/faults/calls.h"

namespace faults
{

struct Effort {
    uint64_t each;        // first allocations that are all failed, alone and with all later ones
    double growth;        // then the step to the next grows by this share
    uint32_t frames;      // return addresses that tell one place from another
    uint64_t each_place;  // a call of at most this many allocations fails at each place
    uint64_t large;       // a call of more allocations fails at few of them
    uint32_t states;      // in which a call that grows tables is tried
};
extern const Effort brief, thorough;

struct Outcome {
    uint64_t allocations = 0, faults = 0, did_without = 0, places = 0, failed_places = 0;
    std::string problem;  // "": none
};

// In a child of its own.
Outcome try_call(World &world, const Call &call, const Effort &effort);

}  // namespace faults
