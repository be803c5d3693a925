// What a comparison says, number by number: the names are those of tolerance files and reports.
#pragma once

#include <string>
#include <vector>

namespace parity
{

struct Measure {
    std::string name;   // "positions.max_relative"
    double value = 0;   // may be infinite
    std::string unit;   // "m", "pixels", "" for a plain number
    std::string where;  // what the value is of, for a person; may be empty
};

// Everything that can be measured, in the order of reports. larger_is_worse: false of PSNR and SSIM.
struct MeasureKind {
    const char *name;
    const char *meaning;
    bool larger_is_worse;
};
const std::vector<MeasureKind> &measure_kinds();
const MeasureKind *find_kind(const std::string &name);  // null: there is none

// The groups that a tolerance may ask for: "actors", "positions" ...
const std::vector<std::string> &measure_groups();
std::string group_of(const std::string &measure);

}  // namespace parity
