#include "samples/parity/compare.h"

#include <cmath>
#include <cstdio>

#include "samples/parity/compare_parts.h"

namespace parity
{
namespace
{

std::string seconds(double t)
{
    char text[32];
    std::snprintf(text, sizeof text, "%.6g s", t);
    return text;
}

void expect_one_scene(const Capture &a, const Capture &b)
{
    if (a.width != b.width || a.height != b.height)
        throw Unreadable(b.folder + " has a picture of " + std::to_string(b.width) + " x " + std::to_string(b.height) +
                         ", and " + a.folder + " one of " + std::to_string(a.width) + " x " + std::to_string(a.height));
    if (std::fabs(a.time_s - b.time_s) > 1e-6 * (1 + std::fabs(a.time_s)))
        throw Unreadable(b.folder + " shows the time " + seconds(b.time_s) + ", and " + a.folder + " " +
                         seconds(a.time_s));
}

}  // namespace

Comparison compare(const Capture &reference, const Capture &result, double pixels_per_degree)
{
    expect_one_scene(reference, result);
    Comparison out;
    const Pair pair = {reference, result};
    compare_actors(pair, out);
    compare_vertices(pair, out);
    compare_id_maps(pair, out);
    compare_depth(pair, out);
    compare_colour(pair, pixels_per_degree, out);
    if (out.measures.empty())
        throw Unreadable(reference.folder + " and " + result.folder + " have no array in common: nothing to compare");
    return out;
}

}  // namespace parity
