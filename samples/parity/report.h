// A comparison as JSON, text and HTML.
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

// One page without other files and scripts; readable with dark and light themes.
std::string report_html(const Report &report, const std::vector<Figure> &figures);

}  // namespace parity
