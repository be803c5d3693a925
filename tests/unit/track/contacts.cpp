#include "tests/unit/track/contacts.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

namespace claque::test
{

namespace
{

constexpr double down_m = 0.005, other_place_m = 0.02;
constexpr double hold_s = 0.12, stuck_s = 3, stuck_m = 0.3, swing_s = 1, sample_s = 0.01;

double height(const Soleprint &print)
{
    double low = HUGE_VAL;
    for (const glm::dvec3 &p : print.points) low = std::min(low, p.y);
    return low;
}

glm::dvec2 flat(const glm::dvec3 &p) { return {p.x, p.z}; }

glm::dvec2 middle_of(const Soleprint &print, const std::vector<Part> &parts, Part part)
{
    glm::dvec2 sum(0);
    double count = 0;
    for (size_t v = 0; v < parts.size(); ++v)
        if (parts[v] == part) sum += flat(print.points[v]), ++count;
    return sum / std::max(1.0, count);
}

bool is_down(const Soleprint &print, const std::vector<Part> &parts, Part part)
{
    for (size_t v = 0; v < parts.size(); ++v)
        if (parts[v] == part && print.points[v].y < down_m) return true;
    return false;
}

// The horizontal way of the vertex that is lower than the others at both of two samples.
double slip_between(const Soleprint &a, const Soleprint &b)
{
    double low = HUGE_VAL, way = 0;
    for (size_t v = 0; v < a.points.size(); ++v) {
        const double own = std::max(a.points[v].y, b.points[v].y);
        if (own < low) low = own, way = glm::length(flat(b.points[v]) - flat(a.points[v]));
    }
    return way;
}

struct Run {
    size_t first, last;
};

// The unbroken runs of samples for which a test holds.
template <class Test>
std::vector<Run> runs_of(size_t count, const Test &holds)
{
    std::vector<Run> out;
    for (size_t i = 0; i < count; ++i) {
        if (!holds(i)) continue;
        if (!out.empty() && out.back().last + 1 == i) out.back().last = i;
        else out.push_back({i, i});
    }
    return out;
}

// How far a vertex gets from where it is at the beginning of a run.
double moved_in(const std::vector<Soleprint> &prints, const Run &run, size_t vertex)
{
    double most = 0;
    for (size_t i = run.first; i <= run.last; ++i)
        most = std::max(most, glm::length(flat(prints[i].points[vertex]) - flat(prints[run.first].points[vertex])));
    return most;
}

// Radians that the vertices which are down at both of two samples turn by.
double turn_between(const Soleprint &a, const Soleprint &b)
{
    const auto down = [&](size_t v) { return std::max(a.points[v].y, b.points[v].y) < down_m; };
    glm::dvec2 from(0), to(0);
    double count = 0, along = 0, across = 0;
    for (size_t v = 0; v < a.points.size(); ++v)
        if (down(v)) from += flat(a.points[v]), to += flat(b.points[v]), ++count;
    if (count < 2) return 0;
    for (size_t v = 0; v < a.points.size(); ++v) {
        if (!down(v)) continue;
        const glm::dvec2 p = flat(a.points[v]) - from / count, q = flat(b.points[v]) - to / count;
        along += glm::dot(p, q), across += p.x * q.y - p.y * q.x;
    }
    return along > 1e-4 ? std::atan2(across, along) : 0;
}

double turned_in(const std::vector<Soleprint> &prints, const Run &run)
{
    double now = 0, least = 0, most = 0;
    for (size_t i = run.first; i < run.last; ++i) {
        now += turn_between(prints[i], prints[i + 1]);
        least = std::min(least, now), most = std::max(most, now);
    }
    return (most - least) * 180 / M_PI;
}

// Whether the person moves for long while the foot is down: what stands may stay.
bool is_dragged(const std::vector<Soleprint> &prints, const Run &run)
{
    double moving_s = 0, way = 0;
    for (size_t i = run.first; i < run.last; ++i) {
        const double step = glm::length(prints[i + 1].body - prints[i].body);
        if (step > 0.01 * sample_s) moving_s += sample_s, way += step;
    }
    return moving_s > stuck_s && way > stuck_m;
}

}  // namespace

double Spread::mean() const
{
    double sum = 0;
    for (const double d : each) sum += d;
    return each.empty() ? 0 : sum / double(each.size());
}

double Spread::at_share(double share) const
{
    if (each.empty()) return 0;
    std::vector<double> sorted = each;
    std::sort(sorted.begin(), sorted.end());
    return sorted[std::min(sorted.size() - 1, static_cast<size_t>(share * double(sorted.size())))];
}

void Contacts::add(const Contacts &other)
{
    slips.add(other.slips), holds.add(other.holds), flats.add(other.flats), lifts.add(other.lifts);
    turns.add(other.turns), depths.add(other.depths);
    dragged += other.dragged;
}

std::string Contacts::row() const
{
    char text[200];
    std::snprintf(text, sizeof text,
                  "%5zu | %5.1f %5.1f %5.1f | %5.1f %5.1f %5.1f | %5.1f | %6.1f %6.1f | %5.1f | %5.1f %5.1f | %d",
                  slips.each.size(), 1e3 * slips.mean(), 1e3 * slips.at_share(0.95), 1e3 * slips.max(),
                  1e3 * holds.mean(), 1e3 * holds.at_share(0.95), 1e3 * holds.max(), 1e3 * flats.max(),
                  1e3 * lifts.min(), 1e3 * lifts.mean(), -1e3 * depths.max(), turns.at_share(0.95), turns.max(),
                  dragged);
    return text;
}

Contacts contacts_of(const std::vector<Soleprint> &prints, const std::vector<Part> &parts)
{
    Contacts out;
    std::vector<double> heights;
    for (const Soleprint &print : prints) heights.push_back(height(print));
    const std::vector<Run> contacts = runs_of(prints.size(), [&](size_t i) { return heights[i] < down_m; });
    if (contacts.empty() && prints.back().time_s - prints.front().time_s > swing_s) ++out.dragged;
    for (size_t c = 0; c < contacts.size(); ++c) {
        const Run &run = contacts[c];
        double slip = 0;
        for (size_t i = run.first; i < run.last; ++i) slip += slip_between(prints[i], prints[i + 1]);
        out.slips.each.push_back(slip);
        out.turns.each.push_back(turned_in(prints, run));
        out.dragged += is_dragged(prints, run);
        if (c == 0) continue;
        const Run &before = contacts[c - 1];
        // The middle of the ball is where it was but for the roll of the foot.
        const auto place = [&](size_t i) { return middle_of(prints[i], parts, Part::ball); };
        if (glm::length(place(run.first) - place(before.last)) > other_place_m)
            out.lifts.each.push_back(
                *std::max_element(heights.begin() + ptrdiff_t(before.last), heights.begin() + ptrdiff_t(run.first)));
    }
    for (size_t v = 0; v < parts.size(); ++v)
        for (const Run &run : runs_of(prints.size(), [&](size_t i) { return prints[i].points[v].y < down_m; }))
            if (double(run.last - run.first) * sample_s >= hold_s) out.holds.each.push_back(moved_in(prints, run, v));
    const auto both = [&](size_t i) {
        return is_down(prints[i], parts, Part::heel) && is_down(prints[i], parts, Part::ball);
    };
    for (const Run &run : runs_of(prints.size(), both)) {
        double most = 0;
        for (size_t v = 0; v < parts.size(); ++v)
            if (parts[v] == Part::heel || parts[v] == Part::ball) most = std::max(most, moved_in(prints, run, v));
        out.flats.each.push_back(most);
    }
    out.depths.each.push_back(-*std::min_element(heights.begin(), heights.end()));
    return out;
}

}  // namespace claque::test
