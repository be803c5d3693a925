#include "lib/lod/proxies/view_cost.h"

#include <numeric>

namespace claque::lod
{

ViewCost::ViewCost(const ZonesInViews &views, size_t triangles, size_t zones, double weight)
    : triangles_(triangles),
      zones_(zones),
      products_(triangles * triangles, 0),
      wanted_(triangles * zones, 0),
      sums_(triangles * zones, 0),
      shown_(triangles, no_zone)
{
    const double each = views.source.empty() ? 0 : weight / double(views.source.size());
    for (size_t v = 0; v < views.source.size(); ++v) {
        const std::vector<double> &here = views.triangles[v], &there = views.source[v];
        if (std::accumulate(there.begin(), there.end(), 0.0) == 0) continue;  // the back of what has one side
        for (size_t t = 0; t < triangles; ++t) {
            if (here[t] == 0) continue;
            for (size_t u = 0; u < triangles; ++u) products_[t * triangles + u] += each * here[t] * here[u];
            for (size_t z = 0; z < zones; ++z) wanted_[t * zones + z] += each * here[t] * there[z];
        }
    }
}

double ViewCost::cost() const
{
    double sum = 0;
    for (size_t t = 0; t < triangles_; ++t)
        if (shown_[t] != no_zone) sum += together(t, shown_[t]) - 2 * wanted(t, shown_[t]);
    return sum;
}

void ViewCost::added(size_t triangle, const std::vector<size_t> &zones, std::vector<double> &out) const
{
    out.resize(zones_ + 1);
    for (size_t zone = 0; zone < zones_; ++zone) out[zone] = own(triangle) - 2 * wanted(triangle, zone);
    for (size_t t = 0; t < triangles_; ++t)
        if (t != triangle) out[zones[t]] += 2 * products_[triangle * triangles_ + t];
}

void ViewCost::set(size_t triangle, size_t was, size_t zone)
{
    for (size_t t = 0; t < triangles_; ++t) {
        const double product = products_[triangle * triangles_ + t];
        if (was != no_zone) sums_[t * zones_ + was] -= product;
        sums_[t * zones_ + zone] += product;
    }
    shown_[triangle] = zone;
}

}  // namespace claque::lod
