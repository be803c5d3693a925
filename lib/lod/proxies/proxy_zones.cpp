#include "lib/lod/proxies/proxy_zones.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include <glm/common.hpp>

#include "lib/lod/surface/nearest.h"
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

using ZoneValues = std::vector<double>;

// The cost of each zone on each triangle, in fractions of the surface: the part of what the triangle represents that
// shows another zone and, for zones that are absent there, their distance as a fraction of the character's size.
class ZoneCost
{
public:
    ZoneCost(const model::Model &model, const PosedParts &source, const PosedParts &level,
             const std::vector<ZoneAreas> &zone_areas, const ZoneValues &areas, const std::vector<double> &weights)
        : zones_(model.zones.size() + 1)
    {
        std::vector<std::vector<NearestPoint::Triangle>> centres(zones_);
        glm::dvec3 first(std::numeric_limits<double>::infinity()), last = -first;
        for (uint32_t t = 0; t < source.triangles().size(); ++t) {
            const glm::dvec3 third(1.0 / 3);
            const glm::dvec3 p = position_of(source, {t, third});
            first = glm::min(first, p), last = glm::max(last, p);
            centres[std::min<size_t>(zone_at(model, source, {t, third}), zones_ - 1)].push_back({p, p, p});
        }
        const double size = std::max({last.x - first.x, last.y - first.y, last.z - first.z, 1e-30});
        std::vector<NearestPoint> nearest;
        std::vector<uint32_t> known;
        for (uint32_t zone = 0; zone < zones_; ++zone)
            if (!centres[zone].empty()) known.push_back(zone), nearest.emplace_back(std::move(centres[zone]));
        for (uint32_t t = 0; t < level.triangles().size(); ++t) {
            ZoneValues row(zones_, 4);
            double all = 0;
            for (const auto &[zone, area] : zone_areas[t]) all += area;
            const glm::dvec3 middle = position_of(level, {t, glm::dvec3(1.0 / 3)});
            for (size_t i = 0; i < known.size(); ++i)
                row[known[i]] = 1 + std::sqrt(nearest[i].to(middle).distance_squared) / size;
            for (const auto &[zone, area] : zone_areas[t])
                row[std::min<size_t>(zone, zones_ - 1)] = all > 0 ? 1 - area / all : 0;
            for (double &one : row) one *= weights.empty() ? areas[t] : weights[t] * areas[t];
            rows_.push_back(std::move(row));
        }
    }
    double of(size_t triangle, size_t zone) const { return rows_[triangle][zone]; }
    size_t zones() const { return zones_; }
    // Of the zones that `fractions` has, if it has any.
    size_t cheapest(size_t triangle, const ZoneValues &fractions) const
    {
        const ZoneValues &row = rows_[triangle];
        const auto is_less = [&](size_t a, size_t b) {
            return (fractions[a] > 0) != (fractions[b] > 0) ? fractions[a] > 0 : row[a] < row[b];
        };
        size_t best = 0;
        for (size_t zone = 1; zone < zones_; ++zone)
            if (is_less(zone, best)) best = zone;
        return best;
    }

private:
    size_t zones_;
    std::vector<ZoneValues> rows_;
};

class ZoneAssignment
{
public:
    ZoneAssignment(const PosedParts &level, const ZoneCost &zone_cost, const ZoneValues &areas, const ZoneGoals &goals)
        : zone_cost_(zone_cost),
          view_cost_(goals.views, areas.size(), goals.area_fractions.size(), view_weight),
          areas_(areas),
          source_fractions_(goals.area_fractions),
          zone_tolerance_(kept_tolerance * goals.tolerance),
          neighbours_(neighbours_of(level)),
          area_fractions_(source_fractions_.size(), 0)
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
        std::vector<PartialAssignment> partials(1), next;
        partials[0].zones.assign(areas_.size(), source_fractions_.size()),
            partials[0].area_fractions.assign(source_fractions_.size(), 0);
        const size_t maximum = beam_width / std::max<size_t>(areas_.size(), 1) + 1;
        for (const size_t t : order) {
            next.clear();
            for (const PartialAssignment &partial : partials)
                for (size_t zone = 0; zone < source_fractions_.size(); ++zone) {
                    if (!may_show(t, zone)) continue;
                    if (partial.area_fractions[zone] + areas_[t] > source_fractions_[zone] + zone_tolerance_ &&
                        zone != cheapest_[t])
                        continue;
                    next.push_back(partial);
                    next.back().cost += view_cost_.added(t, zone, partial.zones);
                    next.back().assign(t, zone, areas_[t], zone_cost_.of(t, zone), neighbours_[t]);
                    const double over = next.back().area_fractions[zone] - source_fractions_[zone] - zone_tolerance_;
                    next.back().cost += excess_penalty * std::clamp(over, 0.0, areas_[t]);
                }
            const auto cheaper = [](const PartialAssignment &a, const PartialAssignment &b) { return a.cost < b.cost; };
            std::stable_sort(next.begin(), next.end(), cheaper);
            if (next.size() > maximum) next.resize(maximum);
            partials.swap(next);
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
    struct PartialAssignment {
        std::vector<size_t> zones;
        ZoneValues area_fractions;
        double cost = 0;
        void assign(size_t t, size_t zone, double area, double zone_cost, const std::vector<uint32_t> &beside)
        {
            zones[t] = zone, area_fractions[zone] += area;
            cost += zone_cost - seam_penalty * double(std::count_if(beside.begin(), beside.end(), [&](uint32_t other) {
                                    return zones[other] == zone;
                                }));
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
    // Searches all sequences of changes that begin with changes_. With more than `very_few` triangles a sequence
    // continues only if some zone has an excess, and only with changes that affect it.
    void search(size_t at_once, double so_far)
    {
        for (size_t t = 0; t < areas_.size(); ++t) {
            const size_t was = zones_[t];
            const double was_off = excess_cost(was, area_fractions_[was]);
            if (std::any_of(changes_.begin(), changes_.end(), [t](const Change &c) { return c.triangle == t; }))
                continue;
            for (size_t zone = 0; zone < source_fractions_.size(); ++zone) {
                if (zone == was || !may_show(t, zone)) continue;
                if (areas_.size() > very_few && changes_.size() + at_once > 1 && was_off == 0 &&
                    excess_cost(zone, area_fractions_[zone]) == 0)
                    continue;
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
    }

    const ZoneCost &zone_cost_;
    ViewCost view_cost_;
    const ZoneValues &areas_, &source_fractions_;
    double zone_tolerance_;
    std::vector<std::vector<uint32_t>> neighbours_;
    ZoneValues area_fractions_;
    std::vector<size_t> zones_, cheapest_;
    std::vector<Change> changes_, best_;
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
    ZoneAssignment assignment(level, zone_cost, areas, goals);
    assignment.improve();
    ZoneAssignment other(level, zone_cost, areas, goals);
    other.start_from(other.beam_search());
    other.improve();
    if (other.cost() < assignment.cost()) assignment.start_from(other.zones());
    std::vector<uint32_t> zones;
    for (const size_t zone : assignment.zones())
        zones.push_back(zone == model.zones.size() ? model::none : static_cast<uint32_t>(zone));
    return zones;
}

}  // namespace claque::lod
