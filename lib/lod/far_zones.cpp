#include "lib/lod/far_zones.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <limits>
#include <numeric>

#include "lib/lod/nearest.h"
#include "lib/lod/seen.h"

namespace claque::lod
{

namespace
{

constexpr double zone_tolerance = 0.0195;  // of a share: just below the 2 points that are promised
constexpr double price = 100;              // of a share beyond it, against harm
constexpr double seam = 0.004;  // of a share: where triangles that share an edge show two zones, vertices stand twice
constexpr size_t most_rounds = 2000;
constexpr size_t few = 64;      // triangles: what is worth a longer search
constexpr size_t beam = 20000;  // ways that are kept while the next triangle is looked at, times triangles

using ZoneRow = std::vector<double>;

// What showing each zone on each triangle does harm, in shares of the surface: the part of what the triangle stands for
// that shows another, and for zones that are not there how far off they are, in sizes of the character.
class Harm
{
public:
    Harm(const model::Model &model, const PosedParts &source, const PosedParts &level,
         const std::vector<ZoneAreas> &seen, const ZoneRow &areas)
        : zones_(model.zones.size() + 1)
    {
        std::vector<std::vector<NearestPoint::Triangle>> places(zones_);
        glm::dvec3 first(std::numeric_limits<double>::infinity()), last = -first;
        for (uint32_t t = 0; t < source.triangles().size(); ++t) {
            const glm::dvec3 third(1.0 / 3);
            const glm::dvec3 p = where(source, {t, third});
            first = glm::min(first, p), last = glm::max(last, p);
            places[std::min<size_t>(zone_at(model, source, {t, third}), zones_ - 1)].push_back({p, p, p});
        }
        const double size = std::max({last.x - first.x, last.y - first.y, last.z - first.z, 1e-30});
        std::vector<NearestPoint> nearest;
        std::vector<uint32_t> known;
        for (uint32_t zone = 0; zone < zones_; ++zone)
            if (!places[zone].empty()) known.push_back(zone), nearest.emplace_back(std::move(places[zone]));
        for (uint32_t t = 0; t < level.triangles().size(); ++t) {
            ZoneRow row(zones_, 4);
            double all = 0;
            for (const auto &[zone, area] : seen[t]) all += area;
            const glm::dvec3 middle = where(level, {t, glm::dvec3(1.0 / 3)});
            for (size_t i = 0; i < known.size(); ++i)
                row[known[i]] = 1 + std::sqrt(nearest[i].to(middle).distance_squared) / size;
            for (const auto &[zone, area] : seen[t])
                row[std::min<size_t>(zone, zones_ - 1)] = all > 0 ? 1 - area / all : 0;
            for (double &one : row) one *= areas[t];
            rows_.push_back(std::move(row));
        }
    }
    double of(size_t triangle, size_t zone) const { return rows_[triangle][zone]; }
    size_t zones() const { return zones_; }
    size_t least(size_t triangle) const
    {
        return size_t(std::min_element(rows_[triangle].begin(), rows_[triangle].end()) - rows_[triangle].begin());
    }

private:
    size_t zones_;
    std::vector<ZoneRow> rows_;
};

class Choice
{
public:
    Choice(const PosedParts &level, const Harm &harm, const ZoneRow &areas, const ZoneRow &wanted)
        : harm_(harm), areas_(areas), wanted_(wanted), beside_(neighbours_of(level)), shares_(wanted.size(), 0)
    {
        for (size_t t = 0; t < areas.size(); ++t) {
            zones_.push_back(harm.least(t));
            shares_[zones_[t]] += areas[t];
        }
    }

    // The best change of one triangle while one helps; then the best of two at once, of three.
    void improve()
    {
        const size_t most_at_once = areas_.size() <= few ? 3 : 2;
        for (size_t round = 0, at_once = 1; round < most_rounds && at_once <= most_at_once; ++round) {
            best_.clear(), most_ = 1e-12;
            look(at_once, 0);
            for (const Change &change : best_) set(change);
            at_once = best_.empty() ? at_once + 1 : 1;
        }
    }
    const std::vector<size_t> &zones() const { return zones_; }
    void start_from(const std::vector<size_t> &zones)
    {
        for (size_t t = 0; t < zones.size(); ++t) set({t, zones[t]});
    }
    // What it comes to: harm, shares that are off, seams.
    double cost() const
    {
        double sum = 0;
        for (size_t t = 0; t < zones_.size(); ++t) sum += harm_.of(t, zones_[t]) - 0.5 * seam * alike(t, zones_[t]);
        for (size_t zone = 0; zone < wanted_.size(); ++zone) sum += beyond(zone, shares_[zone]);
        return sum;
    }
    // A good whole to start from: triangles one after the other, the largest first, in the best of all ways so far, so that small ones
    // are left to make up the shares (a beam search).
    std::vector<size_t> begun() const
    {
        std::vector<size_t> order(areas_.size());
        std::iota(order.begin(), order.end(), size_t(0));
        std::stable_sort(order.begin(), order.end(), [&](size_t a, size_t b) { return areas_[a] > areas_[b]; });
        std::vector<Way> ways(1), next;
        ways[0].zones.assign(areas_.size(), wanted_.size()), ways[0].shares.assign(wanted_.size(), 0);
        const size_t most = beam / std::max<size_t>(areas_.size(), 1) + 1;
        for (const size_t t : order) {
            next.clear();
            for (const Way &way : ways)
                for (size_t zone = 0; zone < wanted_.size(); ++zone) {
                    if (way.shares[zone] + areas_[t] > wanted_[zone] + zone_tolerance && zone != harm_.least(t))
                        continue;
                    next.push_back(way);
                    next.back().take(t, zone, areas_[t], harm_.of(t, zone), beside_[t]);
                    const double over = next.back().shares[zone] - wanted_[zone] - zone_tolerance;
                    next.back().cost += price * std::clamp(over, 0.0, areas_[t]);
                }
            const auto cheaper = [](const Way &a, const Way &b) { return a.cost < b.cost; };
            std::stable_sort(next.begin(), next.end(), cheaper);
            if (next.size() > most) next.resize(most);
            ways.swap(next);
        }
        const auto short_of = [&](const Way &way) {
            double sum = way.cost;
            for (size_t zone = 0; zone < wanted_.size(); ++zone)
                sum += price * std::max(wanted_[zone] - way.shares[zone] - zone_tolerance, 0.0);
            return sum;
        };
        return std::min_element(ways.begin(), ways.end(),
                                [&](const Way &a, const Way &b) { return short_of(a) < short_of(b); })
            ->zones;
    }

private:
    struct Way {
        std::vector<size_t> zones;
        ZoneRow shares;
        double cost = 0;
        void take(size_t t, size_t zone, double area, double harm, const std::vector<uint32_t> &beside)
        {
            zones[t] = zone, shares[zone] += area;
            cost += harm - seam * double(std::count_if(beside.begin(), beside.end(),
                                                       [&](uint32_t other) { return zones[other] == zone; }));
        }
    };
    struct Change {
        size_t triangle = 0, zone = 0;
    };
    double beyond(size_t zone, double share) const
    {
        return price * std::max(std::abs(share - wanted_[zone]) - zone_tolerance, 0.0);
    }
    void set(Change c)
    {
        shares_[zones_[c.triangle]] -= areas_[c.triangle];
        shares_[c.zone] += areas_[c.triangle];
        zones_[c.triangle] = c.zone;
    }
    double gain(Change c) const
    {
        const size_t was = zones_[c.triangle];
        const double a = areas_[c.triangle];
        return harm_.of(c.triangle, was) - harm_.of(c.triangle, c.zone) + beyond(was, shares_[was]) -
               beyond(was, shares_[was] - a) + beyond(c.zone, shares_[c.zone]) - beyond(c.zone, shares_[c.zone] + a) +
               seam * (alike(c.triangle, c.zone) - alike(c.triangle, was));
    }
    // How many triangles beside it show the zone.
    double alike(size_t triangle, size_t zone) const
    {
        const std::vector<uint32_t> &all = beside_[triangle];
        return double(std::count_if(all.begin(), all.end(), [&](uint32_t t) { return zones_[t] == zone; }));
    }
    // Among all rows of changes that begin with row_. A row goes on where some zone has too much or too little, and by
    // what changes that.
    void look(size_t at_once, double so_far)
    {
        for (size_t t = 0; t < areas_.size(); ++t) {
            const size_t was = zones_[t];
            const double was_off = beyond(was, shares_[was]);
            if (std::any_of(row_.begin(), row_.end(), [t](const Change &c) { return c.triangle == t; })) continue;
            for (size_t zone = 0; zone < wanted_.size(); ++zone) {
                if (zone == was) continue;
                if (row_.size() + at_once > 1 && was_off == 0 && beyond(zone, shares_[zone]) == 0) continue;
                const double now = so_far + gain({t, zone});
                row_.push_back({t, zone});
                if (now > most_) most_ = now, best_ = row_;
                if (at_once > 1) {
                    set({t, zone});
                    look(at_once - 1, now);
                    set({t, was});
                }
                row_.pop_back();
            }
        }
    }

    const Harm &harm_;
    const ZoneRow &areas_, &wanted_;
    std::vector<std::vector<uint32_t>> beside_;
    ZoneRow shares_;
    std::vector<size_t> zones_;
    std::vector<Change> row_, best_;
    double most_ = 0;
};

}  // namespace

std::vector<uint32_t> chosen_zones(const model::Model &model, const PosedParts &source, const PosedParts &level,
                                   const std::vector<ZoneAreas> &seen, const std::vector<double> &shares)
{
    ZoneRow areas = seen_areas(model, level);
    const double all = std::accumulate(areas.begin(), areas.end(), 0.0);
    for (double &area : areas) area = all > 0 ? area / all : 0;
    const Harm harm(model, source, level, seen, areas);
    Choice choice(level, harm, areas, shares);
    choice.improve();
    if (areas.size() <= few) {
        Choice other(level, harm, areas, shares);
        other.start_from(other.begun());
        other.improve();
        if (other.cost() < choice.cost()) choice.start_from(other.zones());
    }
    std::vector<uint32_t> zones;
    for (const size_t zone : choice.zones())
        zones.push_back(zone == model.zones.size() ? model::none : static_cast<uint32_t>(zone));
    return zones;
}

}  // namespace claque::lod
