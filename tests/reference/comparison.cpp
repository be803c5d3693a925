#include "tests/reference/comparison.h"

#include <algorithm>
#include <limits>
#include <sstream>

namespace claque::reference
{

Vec3 extent_of(const std::vector<Vec3> &positions)
{
    Vec3 first = positions.at(0), last = first;
    for (const Vec3 &p : positions) {
        first = {std::min(first.x, p.x), std::min(first.y, p.y), std::min(first.z, p.z)};
        last = {std::max(last.x, p.x), std::max(last.y, p.y), std::max(last.z, p.z)};
    }
    return last - first;
}

double size_of(const Character &character)
{
    const std::vector<Vec3> positions = evaluate(character, rest, 0).positions;
    const double size = positions.empty() ? 0 : length(extent_of(positions));
    return size > 0 ? size : 1;
}

Comparison compare(const std::vector<Vec3> &expected, const std::vector<float> &actual, double size)
{
    Comparison result;
    if (actual.size() != 3 * expected.size()) {
        result.worst = std::numeric_limits<double>::infinity();
        result.text = std::to_string(actual.size()) + " numbers for " + std::to_string(expected.size()) + " vertices";
        return result;
    }
    for (size_t v = 0; v < expected.size(); ++v) {
        const Vec3 is{actual[3 * v], actual[3 * v + 1], actual[3 * v + 2]};
        double off = length(is - expected[v]) / size;
        if (!std::isfinite(off)) off = std::numeric_limits<double>::infinity();
        if (off <= result.worst) continue;
        result.worst = off;
        result.vertex = v;
        std::ostringstream text;
        text << "vertex " << v << " is at " << is.x << " " << is.y << " " << is.z << ", expected " << expected[v].x
             << " " << expected[v].y << " " << expected[v].z << ": off by " << off << " of the size " << size;
        result.text = text.str();
    }
    result.same = result.worst <= tolerance;
    return result;
}

}  // namespace claque::reference
