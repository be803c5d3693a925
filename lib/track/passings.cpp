#include "lib/track/passings.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "lib/base/error.h"

namespace claque::track
{

namespace
{

using base::fail;

constexpr double tick_s = 0.2, within_m = 1.0, min_speed_m_s = 0.6;
constexpr double cell_m = 1.4;  // at 5 m/s the nearest tick is half a metre away from the nearest place

// A person on the common grid of times, metres.
struct Walk {
    int64_t first = 0;   // tick
    size_t begin = 0;    // of places
    uint32_t count = 0;  // of ticks
    bool holds(int64_t tick) const { return tick >= first && tick < first + int64_t(count); }
};

struct Entry {
    int64_t tick, x, z;  // x and z of the cell
    uint32_t person;
    auto key() const { return std::make_tuple(tick, x, z, person); }
};

void check(base::Span<const Point> points, uint32_t person)
{
    for (uint32_t i = 0; i < points.count; ++i) {
        const Point &p = points[i];
        const bool good = std::isfinite(p.time_s) && std::fabs(p.time_s) < 1e12 && std::isfinite(p.position.x) &&
                          std::isfinite(p.position.y) && std::isfinite(p.position.z);
        if (!good) fail(CLQ_ARGUMENT, "point %u of person %u is not finite", i, person);
        if (i > 0 && !(p.time_s > points[i - 1].time_s))
            fail(CLQ_ARGUMENT,
                 "point %u of person %u is at %.9g s, that before it at %.9g s: ascending times are wanted", i, person,
                 p.time_s, points[i - 1].time_s);
    }
    if (points.count > 0 && points[points.count - 1].time_s - points[0].time_s > 1e6)
        fail(CLQ_LIMIT, "person %u is there for more than 10^6 s", person);
}

class Search
{
public:
    Search(double metres_per_unit, Array<FoundPassing> &out)
        : metres_per_unit_(metres_per_unit),
          out_(out),
          walks_(out.get_allocator().resource()),
          places_(out.get_allocator().resource()),
          entries_(out.get_allocator().resource())
    {
    }

    void add(base::Span<const Point> points, uint32_t person)
    {
        Walk walk;
        walk.begin = places_.size();
        if (points.count > 0) walk.first = static_cast<int64_t>(std::ceil(points[0].time_s / tick_s));
        uint32_t at = 0;
        for (int64_t tick = walk.first; points.count > 1; ++tick) {
            const double time_s = double(tick) * tick_s;
            if (time_s > points[points.count - 1].time_s) break;
            while (at + 2 < points.count && points[at + 1].time_s <= time_s) ++at;
            const Point &a = points[at], &b = points[at + 1];
            const double part = (time_s - a.time_s) / (b.time_s - a.time_s);
            const glm::dvec3 place = (a.position + (b.position - a.position) * part) * metres_per_unit_;
            places_.push_back(place);
            ++walk.count;
            const double x = std::floor(place.x / cell_m), z = std::floor(place.z / cell_m);
            if (std::fabs(x) < 1e15 && std::fabs(z) < 1e15)
                entries_.push_back({tick, static_cast<int64_t>(x), static_cast<int64_t>(z), person});
        }
        walks_.push_back(walk);
    }

    void run()
    {
        std::sort(entries_.begin(), entries_.end(), [](const Entry &a, const Entry &b) { return a.key() < b.key(); });
        for (size_t i = 0; i < entries_.size(); ++i) {
            const Entry &e = entries_[i];
            for (size_t k = i + 1; k < entries_.size() && is_in(entries_[k], e.tick, e.x, e.z); ++k)
                meet(e, entries_[k].person);
            // Each pair of cells once.
            for (const auto &[dx, dz] : {std::pair{0, 1}, std::pair{1, -1}, std::pair{1, 0}, std::pair{1, 1}})
                meet_cell(e, e.x + dx, e.z + dz);
        }
        std::sort(out_.begin(), out_.end(), [](const FoundPassing &a, const FoundPassing &b) {
            const glm::dvec3 &p = a.passing.position, &q = b.passing.position;
            return std::make_tuple(a.person, a.passing.time_s, p.x, p.z) <
                   std::make_tuple(b.person, b.passing.time_s, q.x, q.z);
        });
    }

private:
    static bool is_in(const Entry &e, int64_t tick, int64_t x, int64_t z)
    {
        return e.tick == tick && e.x == x && e.z == z;
    }

    void meet_cell(const Entry &e, int64_t x, int64_t z)
    {
        const Entry from{e.tick, x, z, 0};
        auto at = std::lower_bound(entries_.begin(), entries_.end(), from,
                                   [](const Entry &a, const Entry &b) { return a.key() < b.key(); });
        for (; at != entries_.end() && is_in(*at, e.tick, x, z); ++at) meet(e, at->person);
    }

    const glm::dvec3 &place(uint32_t person, int64_t tick) const
    {
        return places_[walks_[person].begin + static_cast<size_t>(tick - walks_[person].first)];
    }

    // Whether two people are nearest to each other at this tick, and where each is then.
    void meet(const Entry &e, uint32_t other)
    {
        const Walk &a = walks_[e.person], &b = walks_[other];
        const int64_t k = e.tick;
        if (!a.holds(k - 1) || !a.holds(k + 1) || !b.holds(k - 1) || !b.holds(k + 1)) return;
        const auto away = [&](int64_t tick) {
            const glm::dvec3 d = place(other, tick) - place(e.person, tick);
            return glm::dvec3(d.x, 0, d.z);
        };
        const auto square = [](const glm::dvec3 &d) { return d.x * d.x + d.z * d.z; };
        const glm::dvec3 before = away(k - 1), now = away(k), after = away(k + 1);
        if (!(square(now) <= square(before) && square(now) < square(after))) return;
        const glm::dvec3 speed = (after - before) / (2 * tick_s);
        const double fast = square(speed);
        if (!(fast >= min_speed_m_s * min_speed_m_s)) return;
        const double nearest = -(now.x * speed.x + now.z * speed.z) / fast;
        const double part = std::clamp(nearest / tick_s, -1.0, 1.0);
        if (!(square(now + speed * (part * tick_s)) < within_m * within_m)) return;
        const double time_s = (double(k) + part) * tick_s;
        const auto at = [&](uint32_t person) {
            const glm::dvec3 &p = place(person, k), &q = place(person, part < 0 ? k - 1 : k + 1);
            return (p + (q - p) * std::fabs(part)) / metres_per_unit_;
        };
        out_.push_back({e.person, {time_s, at(other)}});
        out_.push_back({other, {time_s, at(e.person)}});
    }

    const double metres_per_unit_;
    Array<FoundPassing> &out_;
    Array<Walk> walks_;
    Array<glm::dvec3> places_;
    Array<Entry> entries_;
};

}  // namespace

void find_passings(base::Span<const base::Span<const Point>> people, double metres_per_unit, Array<FoundPassing> &out)
{
    if (!(metres_per_unit > 0) || !std::isfinite(metres_per_unit))
        fail(CLQ_ARGUMENT, "metres_per_unit is %g: more than 0 is wanted", metres_per_unit);
    out.clear();
    Search search(metres_per_unit, out);
    for (uint32_t i = 0; i < people.count; ++i) {
        check(people[i], i);
        search.add(people[i], i);
    }
    search.run();
}

}  // namespace claque::track
