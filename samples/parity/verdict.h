// Measures checked against a tolerance.
#pragma once

#include "samples/parity/compare.h"
#include "samples/parity/tolerance.h"

namespace parity
{

struct Check {
    std::string measure;
    double value = 0, bound = 0;
    bool at_least = false, kept = false;
};

struct Verdict {
    std::string tolerance;
    std::vector<Check> checks;         // of limits whose measure exists
    std::vector<NotCompared> lacking;  // groups that the tolerance requires
    bool pass = false;

    size_t broken() const;
    const Check *find(const std::string &measure) const;  // null: no limit
};
Verdict verdict_of(const Comparison &comparison, const Tolerance &tolerance);

// "colour.over_2 0.0123 (at most 0.001), positions ..." of the failed checks; empty if none failed.
std::string reasons(const Verdict &verdict, size_t most);

// A value for display: seven digits, without exponents at ordinary sizes.
std::string number_text(double value);

}  // namespace parity
