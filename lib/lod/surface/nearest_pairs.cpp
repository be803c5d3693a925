// Nearest points between two sets of posed parts: PartTrees and nearest_pairs (surface_samples.h).
#include <algorithm>
#include <cmath>
#include <memory>

#include <glm/geometric.hpp>

#include "lib/lod/surface/nearest.h"
#include "lib/lod/surface/surface_samples.h"

namespace claque::lod
{

namespace
{

// The centres of the four triangles that halving the sides makes.
const std::array<glm::dvec3, 4> centre_weights = {glm::dvec3(1, 1, 1) / 3.0, glm::dvec3(4, 1, 1) / 6.0,
                                                  glm::dvec3(1, 4, 1) / 6.0, glm::dvec3(1, 1, 4) / 6.0};
const std::array<glm::dvec3, 3> corner_weights = {glm::dvec3(1, 0, 0), glm::dvec3(0, 1, 0), glm::dvec3(0, 0, 1)};

}  // namespace

struct PartTrees::Tree {
    Tree(const PosedParts &of, std::vector<uint32_t> which)
        : triangles(std::move(which)), nearest(of.corners(triangles))
    {
    }
    std::vector<uint32_t> triangles;
    NearestPoint nearest;
};

PartTrees::PartTrees(const PosedParts &to, uint32_t part_counts) : part_count_(to.part_count())
{
    const bool any = part_counts == model::none;
    if (part_count_ > 1 && (any || part_counts == part_count_)) by_part_.resize(part_count_);
    std::vector<std::vector<uint32_t>> which(to.part_count() + 1);
    for (uint32_t t = 0; t < to.triangles().size(); ++t) {
        which[to.triangles()[t].part].push_back(t);
        which.back().push_back(t);
    }
    bool is_needed = any || by_part_.empty();
    for (size_t i = 0; i < by_part_.size(); ++i) {
        if (!which[i].empty()) by_part_[i] = std::make_unique<Tree>(to, std::move(which[i]));
        else is_needed = true;
    }
    if (is_needed && !which.back().empty()) all_ = std::make_unique<Tree>(to, std::move(which.back()));
}

PartTrees::~PartTrees() = default;

std::vector<PointPair> PartTrees::nearest_pairs(const PosedParts &from) const
{
    std::vector<PointPair> out;
    const bool part_by_part = !by_part_.empty() && from.part_count() == part_count_;
    if (!all_ && !part_by_part) return out;
    // A vertex is a corner of several triangles, and the nearest triangle of one point is mostly that of the next.
    std::vector<SurfacePoint> of_vertex(from.positions().size(), SurfacePoint{model::none, {}});
    uint32_t guess = model::none;
    const size_t count = from.triangles().size(), step = (count + max_matched - 1) / max_matched,
                 centres = count > dense_triangles ? 1 : centre_weights.size();
    out.reserve(max_pairs(count));
    for (uint32_t t = 0; t < count; t += static_cast<uint32_t>(step)) {
        const uint32_t part = from.triangles()[t].part;
        const Tree &tree = part_by_part && by_part_[part] ? *by_part_[part] : *all_;
        const auto nearest = [&](const SurfacePoint &here) {
            const NearestPoint::Found found = tree.nearest.to(position_of(from, here), guess);
            guess = found.triangle;
            return SurfacePoint{tree.triangles[found.triangle], found.weights};
        };
        for (size_t s = 0; s < centres; ++s) {
            const SurfacePoint here = {t, centre_weights[s]};
            out.push_back({here, nearest(here), PointPair::inside, static_cast<uint8_t>(4 / centres)});
        }
        for (uint8_t corner = 0; corner < 3; ++corner) {
            const SurfacePoint here = {t, corner_weights[corner]};
            SurfacePoint &known = of_vertex[from.vertices_of(t)[corner]];
            if (known.triangle == model::none) known = nearest(here);
            out.push_back({here, known, corner});
        }
    }
    return out;
}

std::vector<PointPair> nearest_pairs(const PosedParts &from, const PosedParts &to)
{
    return PartTrees(to, from.part_count()).nearest_pairs(from);
}

std::vector<SurfaceSample> sample_surface(const PosedParts &parts, double count)
{
    constexpr double max_lines = 64;
    std::vector<double> areas;
    double all = 0;
    for (uint32_t t = 0; t < parts.triangles().size(); ++t) areas.push_back(area_of(parts, t)), all += areas.back();
    std::vector<SurfaceSample> found;
    for (uint32_t t = 0; t < areas.size(); ++t) {
        const double n = all > 0 ? std::clamp(std::ceil(std::sqrt(count * areas[t] / all)), 1.0, max_lines) : 1;
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
