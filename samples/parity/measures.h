// The measures of a comparison; their names are those of tolerance files and reports.
#pragma once

#include <string>
#include <vector>

namespace parity
{

struct Measure {
    std::string name;   // "positions.max_relative"
    double value = 0;   // may be infinite
    std::string unit;   // "m", "pixels", "" for a plain number
    std::string where;  // a description of the place of the value; may be empty
};

// All measures in the order of reports. larger_is_worse: false for PSNR and SSIM.
struct MeasureKind {
    const char *name;
    const char *meaning;
    bool larger_is_worse;
};
const std::vector<MeasureKind> &measure_kinds();
const MeasureKind *find_kind(const std::string &name);  // null: there is none

// The groups that a tolerance may require: "actors", "positions" ...
const std::vector<std::string> &measure_groups();
std::string group_of(const std::string &measure);

}  // namespace parity
