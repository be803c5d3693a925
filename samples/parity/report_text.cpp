// A comparison as lines of text, one a measure.
#include <cstdio>

#include "samples/parity/report.h"

namespace parity
{

std::string report_text(const Report &report)
{
    std::string out;
    for (const Measure &m : report.comparison.measures) {
        const Check *check = report.verdict.find(m.name);
        const std::string value = number_text(m.value) + (m.unit.empty() ? "" : " " + m.unit);
        std::string limit;
        if (check)
            limit = std::string(check->kept ? "ok    " : "FAILS ") + (check->at_least ? "at least " : "at most ") +
                    number_text(check->bound);
        char line[160];
        std::snprintf(line, sizeof line, "%-26s%-24s%-28s", m.name.c_str(), value.c_str(), limit.c_str());
        std::string text = line + m.where;
        text.erase(text.find_last_not_of(' ') + 1);
        out += text + "\n";
    }
    for (const NotCompared &absent : report.comparison.not_compared)
        out += absent.group + ": not compared, " + absent.why + "\n";
    return out;
}

}  // namespace parity
