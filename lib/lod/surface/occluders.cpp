#include "lib/lod/surface/occluders.h"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "lib/lod/surface/four.h"

namespace claque::lod
{

namespace
{

bool intersects_box(glm::dvec3 min, glm::dvec3 max, glm::dvec3 from, glm::dvec3 inverse)
{
    const glm::dvec3 a = (min - from) * inverse, b = (max - from) * inverse;
    const glm::dvec3 near = glm::min(a, b), far = glm::max(a, b);
    return std::max({near.x, near.y, near.z, 0.0}) <= std::min({far.x, far.y, far.z});
}

// A bound far above the relative error of a few float operations.
constexpr double rounding = 1e-5;

Four3 splat(const std::array<float, 3> &p) { return {math::splat(p[0]), math::splat(p[1]), math::splat(p[2])}; }

}  // namespace

// Inverses are finite, so a ray that only touches a box hits it.
Occluders::Ray::Ray(glm::dvec3 direction) : dir(direction)
{
    for (int axis = 0; axis < 3; ++axis) {
        inverse[axis] = dir[axis] == 0 ? 1e300 : 1 / dir[axis];
        small_dir[static_cast<size_t>(axis)] = static_cast<float>(dir[axis]);
        small_inverse[static_cast<size_t>(axis)] = static_cast<float>(std::clamp(inverse[axis], -1e18, 1e18));
    }
}

Occluders::Occluders(const std::vector<Corners3> &triangles)
{
    const AabbTree tree(triangles);
    triangles_.reserve(tree.order.size());
    leaves_.reserve((tree.boxes.size() + 1) / 2), nodes_.reserve(tree.boxes.size() / 2);
    for (const uint32_t t : tree.order) {
        const Corners3 &c = triangles[t];
        triangles_.push_back({c[0], c[1] - c[0], c[2] - c[0]});
    }
    const glm::dvec3 maximum = glm::max(glm::abs(tree.boxes[0].min), glm::abs(tree.boxes[0].max));
    size_ = std::max({maximum.x, maximum.y, maximum.z});
    root_ = add(tree, 0);
}

uint32_t Occluders::add(const AabbTree &tree, uint32_t box)
{
    const AabbTree::Box &from = tree.boxes[box];
    if (!from.left) return add_leaf(from) | leaf_bit;
    const auto [children, count] = tree.below(from);
    const size_t at = nodes_.size();
    nodes_.emplace_back();
    for (size_t i = 0; i < 4; ++i) {
        for (int axis = 0; axis < 3; ++axis) {
            const size_t k = static_cast<size_t>(axis);
            const AabbTree::Box &of = tree.boxes[children[std::min(i, count - 1)]];
            nodes_[at].min[k][i] = float(of.min[axis] - rounding * size_);
            nodes_[at].max[k][i] = float(of.max[axis] + rounding * size_);
        }
        const uint32_t child = i < count ? add(tree, children[i]) : none;
        nodes_[at].child[i] = child;
    }
    return static_cast<uint32_t>(at);
}

uint32_t Occluders::add_leaf(const AabbTree::Box &box)
{
    Leaf leaf;
    leaf.min = box.min, leaf.max = box.max, leaf.begin = box.begin, leaf.end = box.end;
    for (uint32_t i = 0; i < 4; ++i) {
        const Triangle &t = triangles_[std::min(box.begin + i, box.end - 1)];
        for (int axis = 0; axis < 3; ++axis) {
            const size_t k = static_cast<size_t>(axis);
            leaf.origin[k][i] = float(t.origin[axis]);
            leaf.u[k][i] = float(t.u[axis]), leaf.v[k][i] = float(t.v[axis]);
        }
        const double u = glm::length(t.u), v = glm::length(t.v);
        leaf.rounding[i] = float(rounding * size_ * std::max(u, v));
        leaf.far_rounding[i] = float(rounding * size_ * u * v);
    }
    leaves_.push_back(leaf);
    return static_cast<uint32_t>(leaves_.size() - 1);
}

// The intersection test of Moeller and Trumbore 1997.
bool Occluders::intersects_triangle(const Triangle &t, glm::dvec3 from, const Ray &ray, double min_distance) const
{
    const glm::dvec3 p = glm::cross(ray.dir, t.v);
    const double determinant = glm::dot(t.u, p);
    if (determinant == 0) return false;
    const glm::dvec3 s = from - t.origin;
    const double b = glm::dot(s, p) / determinant;
    if (!(b >= 0 && b <= 1)) return false;
    const glm::dvec3 q = glm::cross(s, t.u);
    const double c = glm::dot(ray.dir, q) / determinant;
    return c >= 0 && b + c <= 1 && glm::dot(t.v, q) / determinant > min_distance;
}

// The same test for four triangles at once, without division, as a conservative first test.
bool Occluders::intersects_leaf(const Leaf &leaf, glm::dvec3 from, const Ray &ray, double min_distance) const
{
    const Four3 dir = splat(ray.small_dir), at = splat(from), p = cross(dir, leaf.v);
    const math::F4 zero = math::splat(0), determinant = dot(leaf.u, p);
    const Four3 s = {at[0] - leaf.origin[0], at[1] - leaf.origin[1], at[2] - leaf.origin[2]}, q = cross(s, leaf.u);
    const auto turned = determinant < zero;
    const math::F4 size = turned ? -determinant : determinant, b = dot(s, p), c = dot(dir, q), far = dot(leaf.v, q),
                   b_up = turned ? -b : b, c_up = turned ? -c : c, far_up = turned ? -far : far;
    const auto may = (b_up >= -leaf.rounding) & (c_up >= -leaf.rounding) & (b_up + c_up <= size + 4 * leaf.rounding) &
                     (far_up >= math::splat(float(min_distance)) * size - leaf.far_rounding);
    for (uint32_t i = leaf.begin; i < leaf.end; ++i)
        if (may[i - leaf.begin] && intersects_triangle(triangles_[i], from, ray, min_distance))
            return intersects_box(leaf.min, leaf.max, from, ray.inverse);
    return false;
}

bool Occluders::intersects(glm::dvec3 from, Ray &ray, double min_distance) const
{
    if (ray.last_hit < leaves_.size() && intersects_leaf(leaves_[ray.last_hit], from, ray, min_distance)) return true;
    const Four3 at = splat(from), inverse = splat(ray.small_inverse);
    std::array<uint32_t, 128> open;  // at most 16 levels with three siblings each, and four
    size_t count = 0;
    open[count++] = root_;
    while (count) {
        const uint32_t next = open[--count];
        if (next & leaf_bit) {
            const uint32_t leaf = next & ~leaf_bit;
            if (leaf == ray.last_hit || !intersects_leaf(leaves_[leaf], from, ray, min_distance)) continue;
            ray.last_hit = leaf;
            return true;
        }
        const Node &node = nodes_[next];
        math::F4 near = math::splat(0), far = math::splat(3e38f);
        for (size_t k = 0; k < 3; ++k) {
            const math::F4 a = (node.min[k] - at[k]) * inverse[k], b = (node.max[k] - at[k]) * inverse[k];
            near = larger(near, smaller(a, b)), far = smaller(far, larger(a, b));
        }
        const auto met = near <= far;
        for (size_t i = 0; i < 4; ++i)
            if (met[i] && node.child[i] != none) open[count++] = node.child[i];
    }
    return false;
}

}  // namespace claque::lod
