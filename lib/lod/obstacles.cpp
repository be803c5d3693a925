#include "lib/lod/obstacles.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace claque::lod
{

namespace
{

bool meets_box(glm::dvec3 first, glm::dvec3 last, glm::dvec3 from, glm::dvec3 inverse)
{
    const glm::dvec3 a = (first - from) * inverse, b = (last - from) * inverse;
    const glm::dvec3 near = glm::min(a, b), far = glm::max(a, b);
    return std::max({near.x, near.y, near.z, 0.0}) <= std::min({far.x, far.y, far.z});
}

math::F4 smaller(math::F4 a, math::F4 b) { return a < b ? a : b; }
math::F4 larger(math::F4 a, math::F4 b) { return a > b ? a : b; }

}  // namespace

// Finite inverses, so that a box that a ray just touches is one that it meets.
Obstacles::Way::Way(glm::dvec3 direction) : along(direction)
{
    for (int axis = 0; axis < 3; ++axis) {
        inverse[axis] = along[axis] == 0 ? 1e300 : 1 / along[axis];
        small_inverse[static_cast<size_t>(axis)] = static_cast<float>(std::clamp(inverse[axis], -1e18, 1e18));
    }
}

Obstacles::Obstacles(const std::vector<Corners3> &triangles)
{
    const BoxTree tree(triangles);
    for (const uint32_t t : tree.order) {
        const Corners3 &c = triangles[t];
        triangles_.push_back({c[0], c[1] - c[0], c[2] - c[0]});
    }
    const glm::dvec3 most = glm::max(glm::abs(tree.boxes[0].first), glm::abs(tree.boxes[0].last));
    slack_ = 1e-5 * std::max({most.x, most.y, most.z});  // many roundings of floats
    root_ = add(tree, 0);
}

uint32_t Obstacles::add(const BoxTree &tree, uint32_t box)
{
    const BoxTree::Box &from = tree.boxes[box];
    if (!from.left) {
        leaves_.push_back({from.first, from.last, from.begin, from.end});
        return static_cast<uint32_t>(leaves_.size() - 1) | leaf_bit;
    }
    std::vector<uint32_t> children;
    for (const uint32_t child : {from.left, from.left + 1}) {
        const uint32_t left = tree.boxes[child].left;
        if (!left) children.push_back(child);
        else children.push_back(left), children.push_back(left + 1);
    }
    const size_t at = nodes_.size();
    nodes_.emplace_back();
    for (size_t i = 0; i < 4; ++i) {
        for (int axis = 0; axis < 3; ++axis) {
            const size_t k = static_cast<size_t>(axis);
            const BoxTree::Box &of = tree.boxes[children[std::min(i, children.size() - 1)]];
            nodes_[at].first[k][i] = float(of.first[axis] - slack_);
            nodes_[at].last[k][i] = float(of.last[axis] + slack_);
        }
        const uint32_t child = i < children.size() ? add(tree, children[i]) : none;
        nodes_[at].child[i] = child;
    }
    return static_cast<uint32_t>(at);
}

// Moeller and Trumbore 1997.
bool Obstacles::meets_in(const Leaf &leaf, glm::dvec3 from, const Way &way, double after) const
{
    if (!meets_box(leaf.first, leaf.last, from, way.inverse)) return false;
    for (uint32_t i = leaf.begin; i < leaf.end; ++i) {
        const Triangle &t = triangles_[i];
        const glm::dvec3 p = glm::cross(way.along, t.v);
        const double determinant = glm::dot(t.u, p);
        if (determinant == 0) continue;
        const glm::dvec3 s = from - t.origin;
        const double b = glm::dot(s, p) / determinant;
        if (!(b >= 0 && b <= 1)) continue;
        const glm::dvec3 q = glm::cross(s, t.u);
        const double c = glm::dot(way.along, q) / determinant;
        if (c >= 0 && b + c <= 1 && glm::dot(t.v, q) / determinant > after) return true;
    }
    return false;
}

bool Obstacles::meets(glm::dvec3 from, Way &way, double after) const
{
    if (way.last < leaves_.size() && meets_in(leaves_[way.last], from, way, after)) return true;
    const std::array<math::F4, 3> at = {math::splat(float(from.x)), math::splat(float(from.y)),
                                        math::splat(float(from.z))};
    const std::array<math::F4, 3> inverse = {math::splat(way.small_inverse[0]), math::splat(way.small_inverse[1]),
                                             math::splat(way.small_inverse[2])};
    std::array<uint32_t, 128> open;  // three of each of at most 16 nodes on the way down, and four
    size_t count = 0;
    open[count++] = root_;
    while (count) {
        const uint32_t next = open[--count];
        if (next & leaf_bit) {
            const uint32_t leaf = next & ~leaf_bit;
            if (leaf == way.last || !meets_in(leaves_[leaf], from, way, after)) continue;
            way.last = leaf;
            return true;
        }
        const Four &node = nodes_[next];
        math::F4 near = math::splat(0), far = math::splat(3e38f);
        for (size_t k = 0; k < 3; ++k) {
            const math::F4 a = (node.first[k] - at[k]) * inverse[k], b = (node.last[k] - at[k]) * inverse[k];
            near = larger(near, smaller(a, b)), far = smaller(far, larger(a, b));
        }
        const auto met = near <= far;
        for (size_t i = 0; i < 4; ++i)
            if (met[i] && node.child[i] != none) open[count++] = node.child[i];
    }
    return false;
}

}  // namespace claque::lod
