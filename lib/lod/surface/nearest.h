// Nearest points on a set of triangles, by a tree of boxes.
#pragma once

#include "lib/lod/surface/aabb_tree.h"

namespace claque::lod
{

// A triangle with the precomputed values of nearest-point queries.
struct PrecomputedTriangle {
    explicit PrecomputedTriangle(const Corners3 &t);
    // Returns the weights of the corners at the point nearest to p; they are not negative and sum to 1.
    glm::dvec3 nearest(glm::dvec3 p) const;

    Corners3 corners, edges;
    std::array<double, 3> squares;  // of the edges' lengths
    glm::dvec3 normal, min, max;
    double square;  // of the normal's length
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
    // Of several nearest triangles it returns any, always the same. `guess`: a triangle that may be near; it saves time
    // and does not change the result.
    Found to(glm::dvec3 p, uint32_t guess = 0xffffffff) const;

private:
    AabbTree tree_;
    std::vector<PrecomputedTriangle> triangles_;  // in tree order
    std::vector<uint32_t> slots_;                 // [triangles] index into triangles_
    double slack_ = 0;                            // bound of the rounding error of a squared distance
};

// The same by brute force for a few triangles; of none, infinitely far.
NearestPoint::Found nearest_of(const std::vector<PrecomputedTriangle> &triangles, glm::dvec3 p);

// Returns the weights of the corners of `t` at its point nearest to p.
inline glm::dvec3 nearest_on(const Corners3 &t, glm::dvec3 p) { return PrecomputedTriangle(t).nearest(p); }

inline glm::dvec3 point_on(const Corners3 &t, glm::dvec3 weights)
{
    return weights.x * t[0] + weights.y * t[1] + weights.z * t[2];
}

}  // namespace claque::lod
