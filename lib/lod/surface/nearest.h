// Nearest points on a set of triangles, by a tree of boxes.
#pragma once

#include "lib/lod/surface/aabb_tree.h"
#include "lib/math/simd.h"

namespace claque::lod
{

// A triangle with the precomputed values of nearest-point queries.
struct PrecomputedTriangle {
    explicit PrecomputedTriangle(const Corners3 &t);
    // Returns the weights of the corners at the point nearest to p; they are not negative and sum to 1.
    glm::dvec3 nearest(glm::dvec3 p) const;

    Corners3 corners, edges;
    std::array<double, 3> squares;  // of the edges' lengths
    glm::dvec3 normal;
    double square;  // of the normal's length
};

// The coordinates of floats: relative to the centre of all triangles, and at most 1 in size after multiplication.
struct FloatFrame {
    FloatFrame() = default;
    FloatFrame(glm::dvec3 min, glm::dvec3 max);  // of all triangles
    glm::dvec3 centre = glm::dvec3(0);
    double scale = 1;
};

// Four triangles as floats. Rounding makes a distance too large by a known bound at most.
class TriangleBlock
{
public:
    TriangleBlock(const PrecomputedTriangle *triangles, size_t count, const FloatFrame &frame);  // 1 to 4 triangles
    // Returns the squared distances of `p`. `rounding`: the largest error that a coordinate may have; no distance is
    // too large by more than that. Lanes without a triangle repeat the last one.
    math::F4 distances_squared(const std::array<math::F4, 3> &p, math::F4 rounding) const;

private:
    using Four3 = std::array<math::F4, 3>;
    std::array<Four3, 3> corners_, edges_,
        inward_;                               // inward_: of length 1, from each edge
    Four3 normal_;                             // of length 1, or 0 for a needle
    math::F4 nothing_inside_;                  // 0, or far below it for a point or a line
    std::array<math::F4, 3> inverse_squares_;  // of the edges' lengths
};

class NearestPoint
{
public:
    using Triangle = Corners3;
    explicit NearestPoint(const std::vector<Triangle> &triangles);  // at least one triangle

    struct Found {
        uint32_t triangle = 0;
        glm::dvec3 weights = glm::dvec3(0);  // of the triangle's corners
        double distance_squared = 0;
    };
    // Returns the first of several nearest triangles in the tree's order. `guess`: a triangle that may be near; it
    // saves time and does not change the result.
    Found to(glm::dvec3 p, uint32_t guess = 0xffffffff) const;

private:
    struct Node {  // four children
        std::array<math::F4, 3> min, max;
        std::array<uint32_t, 4> child;
    };
    struct Leaf {
        TriangleBlock block;
        uint32_t begin, end;
    };
    static constexpr uint32_t none = 0xffffffff, leaf_bit = 0x80000000;
    uint32_t add(const AabbTree &tree, uint32_t box);

    std::vector<PrecomputedTriangle> triangles_;  // in tree order
    std::vector<uint32_t> order_, slots_;         // from triangles_ to the given ones, and back
    std::vector<Node> nodes_;
    std::vector<Leaf> leaves_;
    FloatFrame frame_;  // of nodes and leaves
    uint32_t root_ = 0;
};

// The same for a few triangles, without a tree.
class FewTriangles
{
public:
    explicit FewTriangles(const std::vector<Corners3> &triangles);  // may be none
    // Returns the first of several nearest triangles; without triangles, an infinite distance.
    NearestPoint::Found to(glm::dvec3 p) const;
    const std::vector<PrecomputedTriangle> &triangles() const { return triangles_; }

private:
    std::vector<PrecomputedTriangle> triangles_;
    FloatFrame frame_;
    std::vector<TriangleBlock> blocks_;
};

// Returns the weights of the corners of `t` at its point nearest to p.
inline glm::dvec3 nearest_on(const Corners3 &t, glm::dvec3 p) { return PrecomputedTriangle(t).nearest(p); }

inline glm::dvec3 point_on(const Corners3 &t, glm::dvec3 weights)
{
    return weights.x * t[0] + weights.y * t[1] + weights.z * t[2];
}

}  // namespace claque::lod
