// A crowd whose people come and go, drawn every hundredth update. A problem is memory that grows, or what is shown if
// it differs from what a fresh run shows at the same time.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace soak
{

struct Plan {
    uint64_t updates = 1000000, seed = 1;
    double seconds = 0;  // at most; 0: as long as the updates take
    // On purpose, to show that a soak sees it: what came before stays in memory; a fresh run misses a command.
    bool leaks = false, forgets = false;
};

struct Outcome {
    std::string skipped;  // because a library is absent
    std::vector<std::string> problems;
};

Outcome run(const Plan &plan);

}  // namespace soak
