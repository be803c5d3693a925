#include "lib/lod/far_balance.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

#include "lib/lod/nearest.h"

namespace claque::lod
{

namespace
{

constexpr double tolerance = 0.0195;  // of a share: just below the 2 points that are promised

// Places that show one zone.
struct ZonePlaces {
    std::vector<Place> places;
    std::unique_ptr<NearestPoint> nearest;
};

// One texel, and for each zone the place of it that is nearest.
struct BalanceRow {
    size_t texel = 0;
    std::vector<uint32_t> place;
    std::vector<double> distance;
};

class Balance
{
public:
    Balance(const FarSource &source, size_t set, std::vector<Shown> &texels)
        : source_(source), set_(set), texels_(texels), wanted_(source.shares[set]), shares_(wanted_.size(), 0)
    {
        for (const Shown &texel : texels)
            if (texel.area > 0) shares_[index(texel.zone)] += texel.area;
    }

    void run()
    {
        if (!off()) return;
        find_distances();
        while (off() && step()) {}
    }

private:
    size_t index(uint32_t zone) const { return std::min<size_t>(zone, wanted_.size() - 1); }
    uint32_t zone(size_t index) const
    {
        return index + 1 == wanted_.size() ? model::none : static_cast<uint32_t>(index);
    }
    double over(size_t z) const { return shares_[z] - wanted_[z]; }
    bool off() const
    {
        for (size_t z = 0; z < wanted_.size(); ++z)
            if (std::abs(over(z)) > tolerance) return true;
        return false;
    }

    // How far each texel is from each zone.
    void find_distances()
    {
        zones_.resize(wanted_.size());
        std::vector<std::vector<NearestPoint::Triangle>> points(wanted_.size());
        for (const Spot &spot : spread(source_.fine, spots_of_a_surface)) {
            const size_t z = index(zone_at(source_.model, source_.fine, spot.place, source_.set(set_)));
            const glm::dvec3 p = where(source_.fine, spot.place);
            zones_[z].places.push_back(spot.place);
            points[z].push_back({p, p, p});
        }
        for (size_t z = 0; z < zones_.size(); ++z)
            if (!points[z].empty()) zones_[z].nearest = std::make_unique<NearestPoint>(std::move(points[z]));
        for (size_t i = 0; i < texels_.size(); ++i) {
            if (!(texels_[i].area > 0)) continue;
            BalanceRow row;
            row.texel = i;
            for (const ZonePlaces &one : zones_) {
                const NearestPoint::Found found = one.nearest ? one.nearest->to(texels_[i].at) : NearestPoint::Found();
                row.place.push_back(found.triangle);
                row.distance.push_back(one.nearest ? std::sqrt(found.distance_squared)
                                                   : std::numeric_limits<double>::infinity());
            }
            rows_.push_back(std::move(row));
        }
    }

    // The one change that moves a border least and brings the zone that is furthest off nearer to its share.
    bool step()
    {
        size_t worst = 0;
        for (size_t z = 0; z < wanted_.size(); ++z)
            if (std::abs(over(z)) > std::abs(over(worst))) worst = z;
        const bool gives = over(worst) > 0;
        double least = std::numeric_limits<double>::infinity();
        const BalanceRow *best = nullptr;
        size_t to = 0;
        for (const BalanceRow &row : rows_) {
            const size_t from = index(texels_[row.texel].zone);
            const double area = texels_[row.texel].area;
            if (gives != (from == worst)) continue;
            if (!gives && over(from) - area < -tolerance) continue;
            for (size_t z = 0; z < wanted_.size(); ++z) {
                if (z == from || (!gives && z != worst) || over(z) + area > tolerance) continue;
                const double moved = row.distance[z] - row.distance[from];
                if (moved < least) least = moved, best = &row, to = z;
            }
        }
        if (!best) return false;
        change(*best, to);
        return true;
    }

    void change(const BalanceRow &row, size_t to)
    {
        Shown &texel = texels_[row.texel];
        shares_[index(texel.zone)] -= texel.area;
        shares_[to] += texel.area;
        texel.zone = zone(to);
        texel.rgb = texel_at(source_.model, source_.fine, zones_[to].places[row.place[to]], source_.set(set_));
    }

    const FarSource &source_;
    size_t set_;
    std::vector<Shown> &texels_;
    const std::vector<double> &wanted_;
    std::vector<double> shares_;
    std::vector<ZonePlaces> zones_;
    std::vector<BalanceRow> rows_;
};

}  // namespace

void balance(const FarSource &source, size_t set, std::vector<Shown> &texels) { Balance(source, set, texels).run(); }

}  // namespace claque::lod
