// How far a result may be from the reference: limits of measures by name.
#pragma once

#include <string>
#include <vector>

#include "samples/parity/npy.h"

namespace parity
{

struct Limit {
    std::string measure;
    double bound = 0;  // maximum; minimum for measures of which more is better
};

struct Tolerance {
    std::string name;
    std::vector<Limit> limits;
    std::vector<std::string> required;  // groups that must be compared
};

const std::vector<Tolerance> &named_tolerances();  // exact, gpu, coarse, loose

// Takes one of these names, or a TOML file: 'require = ["positions"]', tables [at_most] and [at_least] of measures;
// 'base' names a tolerance to start from. Throws Unreadable for an unknown name or file, text that is not TOML (with
// the line), or an unknown measure.
Tolerance tolerance_of(const std::string &name_or_file);
Tolerance tolerance_from(const std::string &toml, const std::string &path);

}  // namespace parity
