#include "samples/parity/verdict.h"

#include <algorithm>
#include <cstdio>

namespace parity
{

size_t Verdict::broken() const
{
    return static_cast<size_t>(std::count_if(checks.begin(), checks.end(), [](const Check &c) { return !c.kept; })) +
           lacking.size();
}

const Check *Verdict::find(const std::string &measure) const
{
    const auto found = std::find_if(checks.begin(), checks.end(), [&](const Check &c) { return c.measure == measure; });
    return found == checks.end() ? nullptr : &*found;
}

Verdict verdict_of(const Comparison &comparison, const Tolerance &tolerance)
{
    Verdict v;
    v.tolerance = tolerance.name;
    for (const Limit &limit : tolerance.limits)
        for (const Measure &m : comparison.measures) {
            if (m.name != limit.measure) continue;
            const bool at_least = !find_kind(m.name)->larger_is_worse;
            // Written so that NaN breaks the limit.
            const bool kept = at_least ? m.value >= limit.bound : m.value <= limit.bound;
            v.checks.push_back({m.name, m.value, limit.bound, at_least, kept});
        }
    for (const std::string &group : tolerance.required)
        for (const NotCompared &absent : comparison.not_compared)
            if (absent.group == group) v.lacking.push_back(absent);
    v.pass = v.broken() == 0;
    return v;
}

std::string reasons(const Verdict &verdict, size_t most)
{
    std::vector<std::string> all;
    for (const NotCompared &absent : verdict.lacking)
        all.push_back(absent.group + " was not compared (" + absent.why + ")");
    for (const Check &c : verdict.checks)
        if (!c.kept)
            all.push_back(c.measure + " is " + number_text(c.value) + " (at " + (c.at_least ? "least " : "most ") +
                          number_text(c.bound) + ")");
    std::string out;
    for (size_t i = 0; i < std::min(most, all.size()); ++i) out += (i ? ", " : "") + all[i];
    return all.size() > most ? out + " and " + std::to_string(all.size() - most) + " more" : out;
}

std::string number_text(double value)
{
    char text[32];
    std::snprintf(text, sizeof text, "%.7g", value);
    return text;
}

}  // namespace parity
