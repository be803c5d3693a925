#include "lib/lod/proxies/proxy_balance.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace claque::lod
{

namespace
{

constexpr double tolerance = 0.01;  // of a zone's area fraction: half of the promised 2 points

// A texel, and for each zone the nearest point that shows it, once it has been asked for.
struct TexelDistances {
    static constexpr double unknown = -1;
    size_t texel = 0;
    std::vector<uint32_t> point;
    std::vector<double> distance;
};

class ZoneBalancer
{
public:
    ZoneBalancer(const ProxySource &source, size_t set, std::vector<ProxyTexel> &texels)
        : source_(source),
          set_(set),
          texels_(texels),
          source_fractions_(source.area_fractions[set]),
          area_fractions_(source_fractions_.size(), 0)
    {
        for (const ProxyTexel &texel : texels)
            if (texel.area > 0) area_fractions_[index(texel.zone)] += texel.area;
    }

    void run()
    {
        if (!is_unbalanced()) return;
        find_points();
        while (is_unbalanced() && step()) {}
    }

private:
    size_t index(uint32_t zone) const { return std::min<size_t>(zone, source_fractions_.size() - 1); }
    uint32_t zone(size_t index) const
    {
        return index + 1 == source_fractions_.size() ? model::none : static_cast<uint32_t>(index);
    }
    double excess(size_t z) const { return area_fractions_[z] - source_fractions_[z]; }
    bool is_unbalanced() const
    {
        for (size_t z = 0; z < source_fractions_.size(); ++z)
            if (std::abs(excess(z)) > tolerance) return true;
        return false;
    }

    void find_points()
    {
        zones_ = &source_.zone_points[set_];
        if (zones_->empty()) {
            own_zones_ = zone_points_of(source_.model, source_.fine, source_.set(set_));
            zones_ = &own_zones_;
        }
        for (size_t i = 0; i < texels_.size(); ++i) {
            if (!(texels_[i].area > 0)) continue;
            TexelDistances row;
            row.texel = i;
            row.point.assign(zones_->size(), 0), row.distance.assign(zones_->size(), TexelDistances::unknown);
            rows_.push_back(std::move(row));
        }
    }

    double distance(TexelDistances &row, size_t z) const
    {
        double &known = row.distance[z];
        if (known != TexelDistances::unknown) return known;
        if (!(*zones_)[z].nearest) return known = std::numeric_limits<double>::infinity();
        const PointTree::Found found = (*zones_)[z].nearest->to(texels_[row.texel].at);
        row.point[z] = found.point;
        return known = std::sqrt(found.distance_squared);
    }

    // Makes the one change that moves a border least and brings the zone with the largest error closer to its fraction.
    bool step()
    {
        size_t worst = 0;
        for (size_t z = 0; z < source_fractions_.size(); ++z)
            if (std::abs(excess(z)) > std::abs(excess(worst))) worst = z;
        const bool gives = excess(worst) > 0;
        double least = std::numeric_limits<double>::infinity();
        const TexelDistances *best = nullptr;
        // A zone that gives does so to any other; one that lacks texels takes them.
        const size_t first = gives ? 0 : worst, last = gives ? source_fractions_.size() : worst + 1;
        size_t to = 0;
        for (TexelDistances &row : rows_) {
            const size_t from = index(texels_[row.texel].zone);
            const double area = texels_[row.texel].area;
            if (gives != (from == worst)) continue;
            if (!gives && excess(from) - area < -tolerance) continue;
            for (size_t z = first; z < last; ++z) {
                if (z == from || excess(z) + area > tolerance) continue;
                const double moved = distance(row, z) - distance(row, from);
                if (moved < least) least = moved, best = &row, to = z;
            }
        }
        if (!best) return false;
        change(*best, to);
        return true;
    }

    void change(const TexelDistances &row, size_t to)
    {
        ProxyTexel &texel = texels_[row.texel];
        area_fractions_[index(texel.zone)] -= texel.area;
        area_fractions_[to] += texel.area;
        texel.zone = zone(to);
        texel.rgb = texel_at(source_.model, source_.fine, (*zones_)[to].points[row.point[to]], source_.set(set_));
    }

    const ProxySource &source_;
    size_t set_;
    std::vector<ProxyTexel> &texels_;
    const std::vector<double> &source_fractions_;
    std::vector<double> area_fractions_;
    std::vector<ZonePoints> own_zones_;  // where the source holds none
    const std::vector<ZonePoints> *zones_ = nullptr;
    std::vector<TexelDistances> rows_;
};

}  // namespace

std::vector<ZonePoints> zone_points_of(const model::Model &model, const PosedParts &fine, const model::TextureSet *set)
{
    const size_t count = model.zones.size() + 1;
    std::vector<ZonePoints> zones(count);
    std::vector<std::vector<glm::dvec3>> places(count);
    for (const SurfaceSample &sample : sample_surface(fine, surface_sample_count)) {
        if (is_hole(model, fine, sample.point, set)) continue;
        const size_t z = std::min<size_t>(zone_at(model, fine, sample.point, set), count - 1);
        zones[z].points.push_back(sample.point);
        places[z].push_back(position_of(fine, sample.point));
    }
    for (size_t z = 0; z < count; ++z)
        if (!places[z].empty()) zones[z].nearest.emplace(places[z]);
    return zones;
}

void balance_zones(const ProxySource &source, size_t set, std::vector<ProxyTexel> &texels)
{
    ZoneBalancer(source, set, texels).run();
}

}  // namespace claque::lod
