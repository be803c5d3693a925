#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <memory>

#include "lib/lod/nearest.h"
#include "lib/lod/samples.h"

namespace claque::lod
{

namespace
{

// Middles of the four triangles that halving the sides makes, then the corners.
const std::array<glm::dvec3, spots_per_triangle> spots = {
    glm::dvec3(1, 1, 1) / 3.0, glm::dvec3(4, 1, 1) / 6.0, glm::dvec3(1, 4, 1) / 6.0, glm::dvec3(1, 1, 4) / 6.0,
    glm::dvec3(1, 0, 0),       glm::dvec3(0, 1, 0),       glm::dvec3(0, 0, 1)};
}  // namespace

std::vector<Pair> nearest_pairs(const PosedParts &from, const PosedParts &to)
{
    struct Tree {
        std::vector<uint32_t> triangles;
        std::unique_ptr<NearestPoint> nearest;
    };
    std::vector<Tree> trees(to.part_count() + 1);
    for (uint32_t t = 0; t < to.triangles().size(); ++t) {
        trees[to.triangles()[t].part].triangles.push_back(t);
        trees.back().triangles.push_back(t);
    }
    for (Tree &tree : trees) {
        std::vector<NearestPoint::Triangle> corners;
        for (const uint32_t t : tree.triangles) corners.push_back(to.corners(to.triangles()[t]));
        if (!corners.empty()) tree.nearest = std::make_unique<NearestPoint>(std::move(corners));
    }
    std::vector<Pair> out;
    if (!trees.back().nearest) return out;
    const bool part_by_part = from.part_count() == to.part_count();
    // A vertex is a corner of several triangles, and what is nearest to one place is mostly so to the next.
    std::vector<Place> of_vertex(from.positions().size(), Place{model::none, {}});
    uint32_t guess = model::none;
    for (uint32_t t = 0; t < from.triangles().size(); ++t) {
        const uint32_t part = from.triangles()[t].part;
        const Tree &own = part_by_part ? trees[part] : trees.back(), &tree = own.nearest ? own : trees.back();
        for (size_t s = 0; s < spots.size(); ++s) {
            const Place here = {t, spots[s]};
            Place *known = s < area_spots ? nullptr : &of_vertex[from.vertices_of(t)[s - area_spots]];
            if (known && known->triangle != model::none) {
                out.push_back({here, *known});
                continue;
            }
            const NearestPoint::Found found = tree.nearest->to(where(from, here), guess);
            guess = found.triangle;
            out.push_back({here, {tree.triangles[found.triangle], found.weights}});
            if (known) *known = out.back().there;
        }
    }
    return out;
}

std::vector<Spot> spread(const PosedParts &parts, double count)
{
    constexpr double most_lines = 64;
    std::vector<double> areas;
    double all = 0;
    for (uint32_t t = 0; t < parts.triangles().size(); ++t) areas.push_back(area_of(parts, t)), all += areas.back();
    std::vector<Spot> found;
    for (uint32_t t = 0; t < areas.size(); ++t) {
        const double n = all > 0 ? std::clamp(std::ceil(std::sqrt(count * areas[t] / all)), 1.0, most_lines) : 1;
        for (double i = 0; i < n; ++i)
            for (double j = 0; i + j < n; ++j)
                for (const double third : {1.0, 2.0}) {
                    if (third == 2 && i + j + 2 > n) continue;
                    const double b = (i + third / 3) / n, c = (j + third / 3) / n;
                    found.push_back({{t, {1 - b - c, b, c}}, areas[t] / (n * n)});
                }
    }
    return found;
}

double area_of(const PosedParts &parts, uint32_t triangle)
{
    const auto c = parts.corners(parts.triangles()[triangle]);
    return 0.5 * glm::length(glm::cross(c[1] - c[0], c[2] - c[0]));
}

}  // namespace claque::lod
