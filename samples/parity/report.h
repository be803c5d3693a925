// A comparison for machines and for people.
#pragma once

#include "samples/parity/verdict.h"

namespace parity
{

struct Report {
    const Capture &reference, &result;
    const Comparison &comparison;
    const Verdict &verdict;
};

std::string report_text(const Report &report);  // a table, a line each
std::string report_json(const Report &report);

// png: a whole file.
struct Figure {
    std::string title, caption;
    std::vector<unsigned char> png;
};

// One page with everything in it, no other file and no script; readable on a dark screen and on a light one.
std::string report_html(const Report &report, const std::vector<Figure> &figures);

}  // namespace parity
