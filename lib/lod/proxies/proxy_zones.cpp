#include "lib/lod/proxies/proxy_zones.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "lib/lod/proxies/zone_cost.h"
#include "lib/lod/surface/visibility.h"

namespace claque::lod
{

namespace
{

constexpr double kept_tolerance = 0.975;  // of the promised tolerance of area fractions
constexpr double excess_penalty = 100;    // weight of an excess beyond the tolerance, against the zone cost

// A zone of at least `least_zone` of the surface shall not vanish: below a third of its fraction, what is missing of
// that costs up to as much as so much of wrong surface.
constexpr double lost_penalty = 0.15;

// Weight of the mean squared error of views (see ViewCost).
constexpr double view_weight = 4;

// The cost of an edge between two zones, in area fractions: its vertices are split.
constexpr double seam_penalty = 0.004;
constexpr size_t max_rounds = 2000;
constexpr size_t few = 64;            // levels of at most so many triangles get a longer search after it
constexpr size_t very_few = 14;       // and of at most so many the longest
constexpr size_t beam_width = 20000;  // partial assignments kept per step, times the number of triangles
// Several changes at once are as many as a power of triangles times zones. After so many tries a search of two or three
// takes only so many changes, those that gain most by themselves. Built-in people take 4.9 million at most.
constexpr uint64_t max_tries = 6'000'000;
constexpr size_t max_of_two = 128, max_of_three = 25;

class ZoneAssignment
{
public:
    // `tries`: of changes at once, of all assignments of the level.
    ZoneAssignment(const PosedParts &level, const ZoneCost &zone_cost, const ZoneValues &areas, const ZoneGoals &goals,
                   uint64_t &tries)
        : zone_cost_(zone_cost),
          view_cost_(goals.views, areas.size(), goals.area_fractions.size(), view_weight),
          areas_(areas),
          source_fractions_(goals.area_fractions),
          zone_tolerance_(kept_tolerance * goals.tolerance),
          neighbours_(neighbours_of(level)),
          area_fractions_(source_fractions_.size(), 0),
          tries_(tries)
    {
        for (size_t t = 0; t < areas.size(); ++t) {
            zones_.push_back(zone_cost.cheapest(t, source_fractions_));
            cheapest_.push_back(zones_[t]);
            area_fractions_[zones_[t]] += areas[t];
            view_cost_.set(t, ViewCost::no_zone, zones_[t]);
        }
    }

    // Applies the best change of one triangle while one helps, then the best of two at once, then of three.
    void improve()
    {
        const size_t max_at_once = areas_.size() <= few ? 3 : 2;
        for (size_t round = 0, at_once = 1; round < max_rounds && at_once <= max_at_once; ++round) {
            best_.clear(), best_gain_ = 1e-12;
            choose_candidates(at_once);
            search(at_once, 0);
            for (const Change &change : best_) set(change);
            at_once = best_.empty() ? at_once + 1 : 1;
        }
    }
    const std::vector<size_t> &zones() const { return zones_; }
    void start_from(const std::vector<size_t> &zones)
    {
        for (size_t t = 0; t < zones.size(); ++t) set({t, zones[t]});
    }
    // Returns the total cost: zone costs, area excess, seams, views.
    double cost() const
    {
        double sum = 0;
        for (size_t t = 0; t < zones_.size(); ++t)
            sum += zone_cost_.of(t, zones_[t]) - 0.5 * seam_penalty * equal_neighbours(t, zones_[t]);
        for (size_t zone = 0; zone < source_fractions_.size(); ++zone) sum += excess_cost(zone, area_fractions_[zone]);
        return sum + view_cost_.cost();
    }
    // Finds a good start by beam search. It assigns the largest triangle first and extends the best partial
    // assignments, so that small triangles are left to balance the fractions.
    std::vector<size_t> beam_search() const
    {
        std::vector<size_t> order(areas_.size());
        std::iota(order.begin(), order.end(), size_t(0));
        std::stable_sort(order.begin(), order.end(), [&](size_t a, size_t b) { return areas_[a] > areas_[b]; });
        std::vector<PartialAssignment> partials(1), kept;
        std::vector<Extension> next;
        std::vector<double> seen;  // by views, of each zone
        partials[0].zones.assign(areas_.size(), source_fractions_.size()),
            partials[0].area_fractions.assign(source_fractions_.size(), 0);
        const size_t maximum = beam_width / std::max<size_t>(areas_.size(), 1) + 1;
        for (const size_t t : order) {
            next.clear();
            for (size_t from = 0; from < partials.size(); ++from) {
                const PartialAssignment &partial = partials[from];
                view_cost_.added(t, partial.zones, seen);
                for (size_t zone = 0; zone < source_fractions_.size(); ++zone) {
                    if (!may_show(t, zone)) continue;
                    const double share = partial.area_fractions[zone] + areas_[t];
                    if (share > source_fractions_[zone] + zone_tolerance_ && zone != cheapest_[t]) continue;
                    double cost = partial.cost;
                    cost += seen[zone];
                    cost += zone_cost_.of(t, zone) - seam_penalty * partial.equal_neighbours(zone, neighbours_[t]);
                    const double over = share - source_fractions_[zone] - zone_tolerance_;
                    cost += excess_penalty * std::clamp(over, 0.0, areas_[t]);
                    next.push_back({cost, from, zone});
                }
            }
            const auto cheaper = [](const Extension &a, const Extension &b) { return a.cost < b.cost; };
            std::stable_sort(next.begin(), next.end(), cheaper);
            if (next.size() > maximum) next.resize(maximum);
            kept.clear();
            for (const Extension &one : next) kept.push_back(partials[one.from]), kept.back().assign(t, one, areas_[t]);
            partials.swap(kept);
        }
        const auto short_of = [&](const PartialAssignment &partial) {
            double sum = partial.cost;
            for (size_t zone = 0; zone < source_fractions_.size(); ++zone)
                sum += excess_penalty *
                       std::max(source_fractions_[zone] - partial.area_fractions[zone] - zone_tolerance_, 0.0);
            return sum;
        };
        return std::min_element(
                   partials.begin(), partials.end(),
                   [&](const PartialAssignment &a, const PartialAssignment &b) { return short_of(a) < short_of(b); })
            ->zones;
    }

private:
    struct Extension {  // of a partial assignment by one triangle
        double cost = 0;
        size_t from = 0, zone = 0;
    };
    struct PartialAssignment {
        std::vector<size_t> zones;
        ZoneValues area_fractions;
        double cost = 0;
        double equal_neighbours(size_t zone, const std::vector<uint32_t> &beside) const
        {
            return double(
                std::count_if(beside.begin(), beside.end(), [&](uint32_t other) { return zones[other] == zone; }));
        }
        void assign(size_t t, const Extension &by, double area)
        {
            zones[t] = by.zone, area_fractions[by.zone] += area, cost = by.cost;
        }
    };
    struct Change {
        size_t triangle = 0, zone = 0;
    };
    // A zone that the source does not show is no choice, unless it shows none at all.
    bool may_show(size_t triangle, size_t zone) const
    {
        return source_fractions_[zone] > 0 || zone == cheapest_[triangle];
    }
    double excess_cost(size_t zone, double share) const
    {
        const double wanted = source_fractions_[zone],
                     lost = wanted >= least_zone ? std::clamp(1 - 3 * share / wanted, 0.0, 1.0) : 0;
        return excess_penalty * std::max(std::abs(share - wanted) - zone_tolerance_, 0.0) + lost_penalty * lost;
    }
    void set(Change c)
    {
        area_fractions_[zones_[c.triangle]] -= areas_[c.triangle];
        area_fractions_[c.zone] += areas_[c.triangle];
        view_cost_.set(c.triangle, zones_[c.triangle], c.zone);
        zones_[c.triangle] = c.zone;
    }
    double gain(Change c) const
    {
        const size_t was = zones_[c.triangle];
        const double a = areas_[c.triangle];
        return zone_cost_.of(c.triangle, was) - zone_cost_.of(c.triangle, c.zone) +
               view_cost_.gain(c.triangle, was, c.zone) + excess_cost(was, area_fractions_[was]) -
               excess_cost(was, area_fractions_[was] - a) + excess_cost(c.zone, area_fractions_[c.zone]) -
               excess_cost(c.zone, area_fractions_[c.zone] + a) +
               seam_penalty * (equal_neighbours(c.triangle, c.zone) - equal_neighbours(c.triangle, was));
    }
    // Returns how many neighbours of the triangle show the zone.
    double equal_neighbours(size_t triangle, size_t zone) const
    {
        const std::vector<uint32_t> &all = neighbours_[triangle];
        return double(std::count_if(all.begin(), all.end(), [&](uint32_t t) { return zones_[t] == zone; }));
    }
    // Sets candidates_, in the order of triangles and zones: all changes or, for several at once after max_tries, those
    // with the largest gains.
    void choose_candidates(size_t at_once)
    {
        candidates_.clear();
        for (size_t t = 0; t < areas_.size(); ++t)
            for (size_t zone = 0; zone < source_fractions_.size(); ++zone)
                if (may_show(t, zone)) candidates_.push_back({t, zone});
        if (at_once == 1 || tries_ < max_tries) return;
        const size_t most = at_once == 2 ? max_of_two : max_of_three;
        std::vector<std::pair<double, Change>> all;
        for (const Change &c : candidates_)
            if (c.zone != zones_[c.triangle]) all.emplace_back(gain(c), c);
        const auto is_better = [](const auto &a, const auto &b) { return a.first > b.first; };
        std::stable_sort(all.begin(), all.end(), is_better);
        all.resize(std::min(all.size(), most));
        candidates_.clear();
        for (const auto &one : all) candidates_.push_back(one.second);
        std::sort(candidates_.begin(), candidates_.end(), [](const Change &a, const Change &b) {
            return a.triangle != b.triangle ? a.triangle < b.triangle : a.zone < b.zone;
        });
    }
    // Searches all sequences of candidates that begin with changes_. With more than `very_few` triangles a sequence
    // continues only if some zone has an excess, and only with changes that affect it.
    void search(size_t at_once, double so_far)
    {
        const bool is_all = tries_ < max_tries;
        size_t before = areas_.size(), was = 0;  // the triangle before, and the zone of this one
        double was_off = 0;
        bool is_taken = false;
        for (size_t i = 0; i < candidates_.size(); ++i) {
            const size_t t = candidates_[i].triangle, zone = candidates_[i].zone;
            if (t != before) {
                before = t, was = zones_[t], was_off = excess_cost(was, area_fractions_[was]);
                is_taken =
                    std::any_of(changes_.begin(), changes_.end(), [t](const Change &c) { return c.triangle == t; });
            }
            if (is_taken || zone == was) continue;
            if (areas_.size() > very_few && changes_.size() + at_once > 1 && was_off == 0 &&
                excess_cost(zone, area_fractions_[zone]) == 0)
                continue;
            if (is_all && changes_.size() + at_once > 1 && ++tries_ >= max_tries) return;
            const double now = so_far + gain({t, zone});
            changes_.push_back({t, zone});
            if (now > best_gain_) best_gain_ = now, best_ = changes_;
            if (at_once > 1) {
                set({t, zone});
                search(at_once - 1, now);
                set({t, was});
            }
            changes_.pop_back();
        }
    }

    const ZoneCost &zone_cost_;
    ViewCost view_cost_;
    const ZoneValues &areas_, &source_fractions_;
    double zone_tolerance_;
    std::vector<std::vector<uint32_t>> neighbours_;
    ZoneValues area_fractions_;
    std::vector<size_t> zones_, cheapest_;
    std::vector<Change> candidates_, changes_, best_;
    uint64_t &tries_;
    double best_gain_ = 0;
};

}  // namespace

std::vector<uint32_t> assign_zones(const model::Model &model, const PosedParts &source, const PosedParts &level,
                                   const std::vector<ZoneAreas> &zone_areas, const ZoneGoals &goals,
                                   const std::vector<double> &weights)
{
    ZoneValues areas = visible_areas(model, level);
    const double all = std::accumulate(areas.begin(), areas.end(), 0.0);
    for (double &area : areas) area = all > 0 ? area / all : 0;
    const ZoneCost zone_cost(model, source, level, zone_areas, areas, weights);
    uint64_t tries = 0;
    ZoneAssignment assignment(level, zone_cost, areas, goals, tries);
    assignment.improve();
    ZoneAssignment other(level, zone_cost, areas, goals, tries);
    other.start_from(other.beam_search());
    other.improve();
    if (other.cost() < assignment.cost()) assignment.start_from(other.zones());
    std::vector<uint32_t> zones;
    for (const size_t zone : assignment.zones())
        zones.push_back(zone == model.zones.size() ? model::none : static_cast<uint32_t>(zone));
    return zones;
}

}  // namespace claque::lod
