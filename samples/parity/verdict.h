// Measures held against a tolerance.
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
    std::vector<Check> checks;         // of limits whose measure there is
    std::vector<NotCompared> lacking;  // groups that the tolerance asks for
    bool pass = false;

    size_t broken() const;
    const Check *find(const std::string &measure) const;  // null: no limit
};
Verdict verdict_of(const Comparison &comparison, const Tolerance &tolerance);

// "colour.over_2 0.0123 (at most 0.001), positions ..." of what failed; empty where nothing did.
std::string reasons(const Verdict &verdict, size_t most);

// A value as people read it: seven digits, no exponents for what is of ordinary size.
std::string number_text(double value);

}  // namespace parity
