// What of a set of triangles is in the way of a ray. Between the files of this room only.
#pragma once

#include "lib/lod/aabb_tree.h"
#include "lib/math/simd.h"

namespace claque::lod
{

class Occluders
{
public:
    explicit Occluders(const std::vector<Corners3> &triangles);  // at least one

    // A unit direction in which rays go, and what was last found in the way of one: rays from places that are near each other
    // mostly end at the same thing.
    struct Ray {
        explicit Ray(glm::dvec3 direction);
        glm::dvec3 dir, inverse;
        std::array<float, 3> small_dir, small_inverse;
        uint32_t last_hit = none;
    };

    // Whether something lies further than `after` along the way.
    bool intersects(glm::dvec3 from, Ray &ray, double min_distance) const;

private:
    static constexpr uint32_t none = 0xffffffff, leaf_bit = 0x80000000;
    struct Triangle {
        glm::dvec3 origin, u, v;
    };
    using Four3 = std::array<math::F4, 3>;
    // Up to four triangles: in floats side by side, which say what is surely not met, and what decides.
    struct Leaf {
        Four3 origin, u, v;
        math::F4 rounding, far_rounding;  // how much roundings may add to what is compared
        glm::dvec3 min, max;
        uint32_t begin, end;
    };
    // Four boxes side by side, a little larger than they are: what they keep back is surely not met.
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
    double size_ = 0;  // no coordinate is further from 0
};

}  // namespace claque::lod
