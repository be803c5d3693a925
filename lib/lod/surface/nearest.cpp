#include "lib/lod/surface/nearest.h"

#include <algorithm>
#include <limits>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace claque::lod
{

namespace
{

double distance_squared(glm::dvec3 min, glm::dvec3 max, glm::dvec3 p)
{
    const glm::dvec3 outside = glm::max(glm::max(min - p, p - max), glm::dvec3(0));
    return glm::dot(outside, outside);
}

}  // namespace

PrecomputedTriangle::PrecomputedTriangle(const Corners3 &t)
    : corners(t),
      edges{t[1] - t[0], t[2] - t[1], t[0] - t[2]},
      normal(glm::cross(t[1] - t[0], t[2] - t[0])),
      min(glm::min(glm::min(t[0], t[1]), t[2])),
      max(glm::max(glm::max(t[0], t[1]), t[2])),
      square(glm::dot(normal, normal))
{
    for (size_t i = 0; i < 3; ++i) squares[i] = glm::dot(edges[i], edges[i]);
}

glm::dvec3 PrecomputedTriangle::nearest(glm::dvec3 p) const
{
    const Corners3 &c = corners, &e = edges;
    const Corners3 to = {p - c[0], p - c[1], p - c[2]};
    if (square > 0) {
        const glm::dvec3 w(glm::dot(glm::cross(e[1], to[1]), normal) / square,
                           glm::dot(glm::cross(e[2], to[2]), normal) / square,
                           glm::dot(glm::cross(e[0], to[0]), normal) / square);
        if (w.x >= 0 && w.y >= 0 && w.z >= 0) return w / (w.x + w.y + w.z);
    }
    glm::dvec3 best(1, 0, 0);
    double least = std::numeric_limits<double>::infinity();
    for (int k = 0; k < 3; ++k) {
        const size_t from = static_cast<size_t>(k), next = (from + 1) % 3;
        const double part = squares[from] > 0 ? std::clamp(glm::dot(to[from], e[from]) / squares[from], 0.0, 1.0) : 0.0;
        const glm::dvec3 off = (1 - part) * c[from] + part * c[next] - p;
        if (const double here = glm::dot(off, off); here < least) {
            least = here;
            best = glm::dvec3(0);
            best[k] = 1 - part, best[static_cast<int>(next)] = part;
        }
    }
    return best;
}

NearestPoint::NearestPoint(const std::vector<Triangle> &triangles) : tree_(triangles), slots_(triangles.size())
{
    for (const uint32_t t : tree_.order) {
        slots_[t] = static_cast<uint32_t>(triangles_.size());
        triangles_.emplace_back(triangles[t]);
    }
    const glm::dvec3 maximum = glm::max(glm::abs(tree_.boxes[0].min), glm::abs(tree_.boxes[0].max));
    slack_ = 1e-18 * glm::dot(maximum, maximum);
}

// Boxes beyond `enough` are skipped. The result is the first of the nearest triangles in tree order, whatever the
// guess; `enough` is a little larger than the guess's distance because rounding decides between equals.
NearestPoint::Found NearestPoint::to(glm::dvec3 p, uint32_t guess) const
{
    Found best;
    best.distance_squared = std::numeric_limits<double>::infinity();
    const double slack = slack_ + 1e-18 * glm::dot(p, p);
    double enough = std::numeric_limits<double>::infinity();
    const auto a_little_more = [slack](double square) { return square + 1e-9 * square + slack; };
    if (guess < slots_.size()) {
        const PrecomputedTriangle &t = triangles_[slots_[guess]];
        const glm::dvec3 off = point_on(t.corners, t.nearest(p)) - p;
        enough = a_little_more(glm::dot(off, off));
    }
    struct Open {
        uint32_t box;
        double square;
    };
    std::array<Open, 128> open;  // the tree halves its range, so its depth is at most the bits of a count
    size_t count = 0;
    open[count++] = {0, 0};
    while (count) {
        const Open next = open[--count];
        if (next.square >= best.distance_squared || next.square > enough) continue;
        const AabbTree::Box &box = tree_.boxes[next.box];
        if (box.left) {
            const AabbTree::Box &left = tree_.boxes[box.left], &right = tree_.boxes[box.left + 1];
            const Open a = {box.left, distance_squared(left.min, left.max, p)},
                       b = {box.left + 1, distance_squared(right.min, right.max, p)};
            const bool left_first = a.square <= b.square;
            open[count++] = left_first ? b : a;
            open[count++] = left_first ? a : b;
            continue;
        }
        for (uint32_t i = box.begin; i < box.end; ++i) {
            const PrecomputedTriangle &t = triangles_[i];
            if (distance_squared(t.min, t.max, p) > enough) continue;
            const glm::dvec3 weights = t.nearest(p);
            const glm::dvec3 off = point_on(t.corners, weights) - p;
            const double square = glm::dot(off, off);
            if (square < best.distance_squared) {
                best = {tree_.order[i], weights, square};
                enough = std::min(enough, a_little_more(square));
            }
        }
    }
    return best;
}

NearestPoint::Found nearest_of(const std::vector<PrecomputedTriangle> &triangles, glm::dvec3 p)
{
    NearestPoint::Found best;
    best.distance_squared = std::numeric_limits<double>::infinity();
    for (uint32_t t = 0; t < triangles.size(); ++t) {
        const glm::dvec3 weights = triangles[t].nearest(p), off = p - point_on(triangles[t].corners, weights);
        const double square = glm::dot(off, off);
        if (square < best.distance_squared) best = {t, weights, square};
    }
    return best;
}

}  // namespace claque::lod
