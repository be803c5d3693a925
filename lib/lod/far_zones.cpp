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

constexpr double tolerance = 0.0195;  // of a share: just below the 2 points that are promised
constexpr double price = 100;         // of a share beyond it, against harm
constexpr size_t most_rounds = 2000;

using Row = std::vector<double>;

// What showing each zone on each triangle does harm, in shares of the surface: the part of what the triangle stands for
// that shows another, and for zones that are not there how far off they are, in sizes of the character.
class Harm
{
public:
    Harm(const model::Model &model, const PosedParts &source, const PosedParts &level,
         const std::vector<ZoneAreas> &seen, const Row &areas)
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
            Row row(zones_, 4);
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
    std::vector<Row> rows_;
};

class Choice
{
public:
    Choice(const Harm &harm, const Row &areas, const Row &wanted)
        : harm_(harm), areas_(areas), wanted_(wanted), shares_(wanted.size(), 0)
    {
        for (size_t t = 0; t < areas.size(); ++t) {
            zones_.push_back(harm.least(t));
            shares_[zones_[t]] += areas[t];
        }
    }

    // The best change of one triangle while one helps; then the best of two at once, of three.
    void improve()
    {
        const size_t most_at_once = areas_.size() <= 64 ? 3 : 2;
        for (size_t round = 0, at_once = 1; round < most_rounds && at_once <= most_at_once; ++round) {
            best_.clear(), most_ = 1e-12;
            look(at_once, 0);
            for (const Change &change : best_) set(change);
            at_once = best_.empty() ? at_once + 1 : 1;
        }
    }
    const std::vector<size_t> &zones() const { return zones_; }

private:
    struct Change {
        size_t triangle = 0, zone = 0;
    };
    double beyond(size_t zone, double share) const
    {
        return price * std::max(std::abs(share - wanted_[zone]) - tolerance, 0.0);
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
               beyond(was, shares_[was] - a) + beyond(c.zone, shares_[c.zone]) - beyond(c.zone, shares_[c.zone] + a);
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
    const Row &areas_, &wanted_;
    Row shares_;
    std::vector<size_t> zones_;
    std::vector<Change> row_, best_;
    double most_ = 0;
};

}  // namespace

std::vector<uint32_t> chosen_zones(const model::Model &model, const PosedParts &source, const PosedParts &level,
                                   const std::vector<ZoneAreas> &seen, const std::vector<double> &shares)
{
    Row areas = seen_areas(model, level);
    const double all = std::accumulate(areas.begin(), areas.end(), 0.0);
    for (double &area : areas) area = all > 0 ? area / all : 0;
    const Harm harm(model, source, level, seen, areas);
    Choice choice(harm, areas, shares);
    choice.improve();
    std::vector<uint32_t> zones;
    for (const size_t zone : choice.zones())
        zones.push_back(zone == model.zones.size() ? model::none : static_cast<uint32_t>(zone));
    return zones;
}

}  // namespace claque::lod
