// The cost of a level's zones as views show them. Internal to lib/lod/proxies.
#pragma once

#include <cstddef>
#include <vector>

namespace claque::lod
{

// What views show: of the source the fraction of each zone, of the level the fraction of each triangle.
struct ZonesInViews {
    std::vector<std::vector<double>> source;     // [views][zones]
    std::vector<std::vector<double>> triangles;  // [views][triangles]
};

// The mean over all views of the squared errors of all zones' fractions, times `weight`, less what it is without any
// triangle. A view in which the source shows nothing counts as one without an error. It is a quadratic form of the
// assignment, so that one change costs a few additions.
class ViewCost
{
public:
    // Without views it is 0.
    ViewCost(const ZonesInViews &views, size_t triangles, size_t zones, double weight);

    double cost() const;
    double gain(size_t triangle, size_t was, size_t zone) const
    {
        return 2 * (together(triangle, was) - together(triangle, zone) - own(triangle)) -
               2 * (wanted(triangle, was) - wanted(triangle, zone));
    }
    // Sets out[zone] to what a triangle that shows it adds to a partial assignment, for all zones. zones[t] is the zone
    // of triangle t, or the number of zones if it has none yet.
    void added(size_t triangle, const std::vector<size_t> &zones, std::vector<double> &out) const;
    // `was` may be no_zone.
    void set(size_t triangle, size_t was, size_t zone);
    static constexpr size_t no_zone = static_cast<size_t>(-1);

private:
    double own(size_t t) const { return products_[t * triangles_ + t]; }
    double together(size_t t, size_t zone) const { return sums_[t * zones_ + zone]; }
    double wanted(size_t t, size_t zone) const { return wanted_[t * zones_ + zone]; }

    size_t triangles_, zones_;
    std::vector<double> products_;  // [triangles][triangles] of two triangles' fractions, over all views
    std::vector<double> wanted_;    // [triangles][zones] of a triangle's and the source's fractions
    std::vector<double> sums_;      // [triangles][zones] of products with the triangles that show the zone
    std::vector<size_t> shown_;     // [triangles] zones
};

}  // namespace claque::lod
