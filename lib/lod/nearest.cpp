#include "lib/lod/nearest.h"

#include <algorithm>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>
#include <numeric>

namespace claque::lod
{

namespace
{

// Weight of b at the point of the line a b that is nearest to p.
double along(glm::dvec3 a, glm::dvec3 b, glm::dvec3 p)
{
    const double square = glm::dot(b - a, b - a);
    return square > 0 ? std::clamp(glm::dot(p - a, b - a) / square, 0.0, 1.0) : 0.0;
}

double distance_squared(glm::dvec3 first, glm::dvec3 last, glm::dvec3 p)
{
    const glm::dvec3 outside = glm::max(glm::max(first - p, p - last), glm::dvec3(0));
    return glm::dot(outside, outside);
}

bool meets_box(glm::dvec3 first, glm::dvec3 last, glm::dvec3 from, glm::dvec3 inverse)
{
    const glm::dvec3 a = (first - from) * inverse, b = (last - from) * inverse;
    const glm::dvec3 near = glm::min(a, b), far = glm::max(a, b);
    return std::max({near.x, near.y, near.z, 0.0}) <= std::min({far.x, far.y, far.z});
}

// How far along, below 0 where it misses (Moeller and Trumbore 1997).
double along_to(const NearestPoint::Triangle &t, glm::dvec3 from, glm::dvec3 along)
{
    const glm::dvec3 u = t[1] - t[0], v = t[2] - t[0], p = glm::cross(along, v), s = from - t[0];
    const double determinant = glm::dot(u, p);
    if (determinant == 0) return -1;
    const double b = glm::dot(s, p) / determinant;
    const glm::dvec3 q = glm::cross(s, u);
    const double c = glm::dot(along, q) / determinant;
    return b >= 0 && c >= 0 && b + c <= 1 ? glm::dot(v, q) / determinant : -1;
}

}  // namespace

glm::dvec3 nearest_on(const NearestPoint::Triangle &t, glm::dvec3 p)
{
    const glm::dvec3 n = glm::cross(t[1] - t[0], t[2] - t[0]);
    const double square = glm::dot(n, n);
    if (square > 0) {
        const glm::dvec3 w(glm::dot(glm::cross(t[2] - t[1], p - t[1]), n) / square,
                           glm::dot(glm::cross(t[0] - t[2], p - t[2]), n) / square,
                           glm::dot(glm::cross(t[1] - t[0], p - t[0]), n) / square);
        if (w.x >= 0 && w.y >= 0 && w.z >= 0) return w / (w.x + w.y + w.z);
    }
    glm::dvec3 best(1, 0, 0);
    double least = std::numeric_limits<double>::infinity();
    for (int k = 0; k < 3; ++k) {
        const int next = (k + 1) % 3;
        glm::dvec3 w(0);
        w[next] = along(t[static_cast<size_t>(k)], t[static_cast<size_t>(next)], p);
        w[k] = 1 - w[next];
        const glm::dvec3 off = point_on(t, w) - p;
        if (glm::dot(off, off) < least) least = glm::dot(off, off), best = w;
    }
    return best;
}

NearestPoint::NearestPoint(std::vector<Triangle> triangles)
    : triangles_(std::move(triangles)), order_(triangles_.size())
{
    std::iota(order_.begin(), order_.end(), 0u);
    boxes_.push_back({{}, {}, 0, static_cast<uint32_t>(order_.size()), 0});
    for (uint32_t box = 0; box < boxes_.size(); ++box) divide(box);
}

void NearestPoint::divide(uint32_t box)
{
    glm::dvec3 first(std::numeric_limits<double>::infinity()), last = -first;
    const uint32_t begin = boxes_[box].begin, end = boxes_[box].end;
    for (uint32_t i = begin; i < end; ++i)
        for (const glm::dvec3 corner : triangles_[order_[i]])
            first = glm::min(first, corner), last = glm::max(last, corner);
    boxes_[box].first = first, boxes_[box].last = last;
    if (end - begin <= 4) return;
    const glm::dvec3 size = last - first;
    const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    const auto middle_of = [&](uint32_t t) {
        return triangles_[t][0][axis] + triangles_[t][1][axis] + triangles_[t][2][axis];
    };
    const uint32_t half = (begin + end) / 2;
    std::nth_element(order_.begin() + begin, order_.begin() + half, order_.begin() + end, [&](uint32_t a, uint32_t b) {
        const double at_a = middle_of(a), at_b = middle_of(b);
        return at_a != at_b ? at_a < at_b : a < b;
    });
    boxes_[box].left = static_cast<uint32_t>(boxes_.size());
    boxes_.push_back({{}, {}, begin, half, 0});
    boxes_.push_back({{}, {}, half, end, 0});
}

NearestPoint::Found NearestPoint::to(glm::dvec3 p) const
{
    Found best;
    best.distance_squared = std::numeric_limits<double>::infinity();
    std::array<uint32_t, 128> open;  // halves of halves: the tree is not deeper than the bits of a count
    size_t count = 0;
    open[count++] = 0;
    while (count) {
        const Box &box = boxes_[open[--count]];
        if (distance_squared(box.first, box.last, p) >= best.distance_squared) continue;
        if (box.left) {
            const Box &left = boxes_[box.left], &right = boxes_[box.left + 1];
            const bool left_first =
                distance_squared(left.first, left.last, p) <= distance_squared(right.first, right.last, p);
            open[count++] = left_first ? box.left + 1 : box.left;
            open[count++] = left_first ? box.left : box.left + 1;
            continue;
        }
        for (uint32_t i = box.begin; i < box.end; ++i) {
            const glm::dvec3 weights = nearest_on(triangles_[order_[i]], p);
            const glm::dvec3 off = point_on(triangles_[order_[i]], weights) - p;
            const double square = glm::dot(off, off);
            if (square < best.distance_squared) best = {order_[i], weights, square};
        }
    }
    return best;
}

bool NearestPoint::meets(glm::dvec3 from, glm::dvec3 along, double after) const
{
    glm::dvec3 inverse;  // finite, so that a box that a ray just touches is one that it meets
    for (int axis = 0; axis < 3; ++axis) inverse[axis] = along[axis] == 0 ? 1e300 : 1 / along[axis];
    std::array<uint32_t, 128> open;
    size_t count = 0;
    open[count++] = 0;
    while (count) {
        const Box &box = boxes_[open[--count]];
        if (!meets_box(box.first, box.last, from, inverse)) continue;
        if (box.left) {
            open[count++] = box.left + 1, open[count++] = box.left;
            continue;
        }
        for (uint32_t i = box.begin; i < box.end; ++i)
            if (along_to(triangles_[order_[i]], from, along) > after) return true;
    }
    return false;
}

}  // namespace claque::lod
