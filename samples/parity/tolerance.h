// How far a result may be from the reference: limits of measures by name.
#pragma once

#include "samples/parity/npy.h"

#include <string>
#include <vector>

namespace parity
{

struct Limit {
    std::string measure;
    double bound = 0;  // at most; at least for measures of which more is better
};

struct Tolerance {
    std::string name;
    std::vector<Limit> limits;
    std::vector<std::string> required;  // groups that have to be compared
};

const std::vector<Tolerance> &named_tolerances();  // exact, gpu, loose

// A name of those, or a TOML file: 'require = ["positions"]', tables [at_most] and [at_least] of measures; 'base' names one
// of those to begin with. Throws Unreadable: no such name or file, what is no TOML (with the line), a measure that there is not.
Tolerance tolerance_of(const std::string &name_or_file);
Tolerance tolerance_from(const std::string &toml, const std::string &path);

}  // namespace parity
