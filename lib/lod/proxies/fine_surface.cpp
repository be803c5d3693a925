#include "lib/lod/proxies/fine_surface.h"

#include <algorithm>

#include <glm/geometric.hpp>

namespace claque::lod
{

std::vector<NearestPoint::Triangle> corners_of(const ClosedMesh &surface)
{
    std::vector<NearestPoint::Triangle> out;
    for (const auto &t : surface.triangles)
        out.push_back({surface.positions[t[0]], surface.positions[t[1]], surface.positions[t[2]]});
    return out;
}

FineSurface::FineSurface(const ClosedMesh &surface, const std::vector<Attributes> &features, size_t max_samples)
    : surface_(surface), nearest_(corners_of(surface))
{
    std::vector<double> areas(surface.positions.size(), 0);
    for (const auto &t : surface.triangles) {
        const double area =
            0.5 * glm::length(twice_area({surface.positions[t[0]], surface.positions[t[1]], surface.positions[t[2]]}));
        for (const uint32_t v : t) areas[v] += area / 3;
        area_ += area;
    }
    // Takes every nth vertex. Marching tetrahedra order vertices row by row in space, so each region gets its share.
    const size_t maximum = std::max<size_t>(max_samples, 1), step = (areas.size() + maximum - 1) / maximum;
    double since = 0;
    for (size_t v = 0; v < areas.size(); ++v) {
        since += areas[v];
        if (v % step != step / 2 && v + 1 != areas.size()) continue;
        samples_.push_back({surface.positions[v], since, &features[v]});
        since = 0;
    }
}

glm::dvec3 FineSurface::nearest(glm::dvec3 p, uint32_t &guess) const
{
    const NearestPoint::Found found = nearest_.to(p, guess);
    guess = found.triangle;
    const auto &t = surface_.triangles[found.triangle];
    return point_on({surface_.positions[t[0]], surface_.positions[t[1]], surface_.positions[t[2]]}, found.weights);
}

}  // namespace claque::lod
