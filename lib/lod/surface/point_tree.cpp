#include "lib/lod/surface/point_tree.h"

#include <limits>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace claque::lod
{

namespace
{

std::vector<Corners3> corners_of(const std::vector<glm::dvec3> &points)
{
    std::vector<Corners3> corners;
    corners.reserve(points.size());
    for (const glm::dvec3 p : points) corners.push_back({p, p, p});
    return corners;
}

// Rounded as a distance is, so that no point of the box is nearer.
double squared_distance(const AabbTree::Box &box, glm::dvec3 p)
{
    const glm::dvec3 off = glm::max(glm::max(box.min - p, p - box.max), glm::dvec3(0));
    return glm::dot(off, off);
}

}  // namespace

PointTree::PointTree(const std::vector<glm::dvec3> &points) : tree_(corners_of(points))
{
    points_.reserve(points.size());
    for (const uint32_t point : tree_.order) points_.push_back(points[point]);
}

PointTree::Found PointTree::to(glm::dvec3 p) const
{
    uint32_t best = 0;
    double least = std::numeric_limits<double>::infinity();
    struct Open {
        uint32_t box;
        double square;
    };
    std::array<Open, 64> open;  // the tree halves its range: at most 32 levels with one sibling each, and one
    size_t count = 0;
    open[count++] = {0, squared_distance(tree_.boxes[0], p)};
    while (count) {
        const Open next = open[--count];
        if (next.square > least) continue;
        const AabbTree::Box &box = tree_.boxes[next.box];
        if (!box.left) {
            for (uint32_t i = box.begin; i < box.end; ++i) {
                const glm::dvec3 off = points_[i] - p;
                const double square = glm::dot(off, off);
                if (square < least || (square == least && i < best)) best = i, least = square;
            }
            continue;
        }
        const Open left = {box.left, squared_distance(tree_.boxes[box.left], p)},
                   right = {box.left + 1, squared_distance(tree_.boxes[box.left + 1], p)};
        const bool left_is_nearer = left.square <= right.square;  // it goes on top
        open[count++] = left_is_nearer ? right : left;
        open[count++] = left_is_nearer ? left : right;
    }
    return {tree_.order[best], least};
}

}  // namespace claque::lod
