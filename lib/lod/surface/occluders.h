// Occlusion queries: whether a ray hits one of a set of triangles. Internal to lib/lod.
#pragma once

#include "lib/lod/surface/aabb_tree.h"
#include "lib/math/simd.h"

namespace claque::lod
{

class Occluders
{
public:
    explicit Occluders(const std::vector<Corners3> &triangles);  // at least one triangle

    // A unit direction of rays, and the leaf that occluded the last one: rays from nearby points are mostly stopped by
    // the same leaf.
    struct Ray {
        explicit Ray(glm::dvec3 direction);
        glm::dvec3 dir, inverse;
        std::array<float, 3> small_dir, small_inverse;
        uint32_t last_hit = none;
    };

    // Returns whether the ray hits something further away than `min_distance`.
    bool intersects(glm::dvec3 from, Ray &ray, double min_distance) const;

private:
    static constexpr uint32_t none = 0xffffffff, leaf_bit = 0x80000000;
    struct Triangle {
        glm::dvec3 origin, u, v;
    };
    using Four3 = std::array<math::F4, 3>;
    // Up to four triangles. The float copies, side by side, reject sure misses; the exact copies decide.
    struct Leaf {
        Four3 origin, u, v;
        math::F4 rounding, far_rounding;  // bounds of the rounding errors of the compared values
        glm::dvec3 min, max;
        uint32_t begin, end;
    };
    // Four boxes side by side, slightly enlarged: a rejected box is surely missed.
    struct Node {
        Four3 min, max;
        std::array<uint32_t, 4> child;  // a node, or a leaf with leaf_bit
    };
    uint32_t add(const AabbTree &tree, uint32_t box);
    uint32_t add_leaf(const AabbTree::Box &box);
    bool intersects_leaf(const Leaf &leaf, glm::dvec3 from, const Ray &ray, double min_distance) const;
    bool intersects_triangle(const Triangle &t, glm::dvec3 from, const Ray &ray, double min_distance) const;

    std::vector<Triangle> triangles_;
    std::vector<Leaf> leaves_;
    std::vector<Node> nodes_;
    uint32_t root_ = 0;
    double size_ = 0;  // the largest absolute coordinate
};

}  // namespace claque::lod
