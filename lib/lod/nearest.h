// The nearest point of a set of triangles, by a tree of boxes.
#pragma once

#include "lib/lod/box_tree.h"

namespace claque::lod
{

class NearestPoint
{
public:
    using Triangle = Corners3;
    explicit NearestPoint(const std::vector<Triangle> &triangles);  // at least one

    struct Found {
        uint32_t triangle = 0;
        glm::dvec3 weights = glm::dvec3(0);  // of its corners: not below 0, their sum 1
        double distance_squared = 0;
    };
    // Of several that are as near, any; always the same. `guess`: a triangle that may be near, which saves time where it is
    // and changes nothing.
    Found to(glm::dvec3 p, uint32_t guess = 0xffffffff) const;

private:
    struct Known {  // of a triangle, once for all places
        Triangle corners, edges;
        std::array<double, 3> squares;  // of the edges' lengths
        glm::dvec3 normal, first, last;
        double square;  // of the normal's length
    };
    static glm::dvec3 nearest_on(const Known &t, glm::dvec3 p);
    friend glm::dvec3 nearest_on(const Triangle &t, glm::dvec3 p);
    static Known known(const Triangle &t);

    BoxTree tree_;
    std::vector<Known> known_;      // in the tree's order
    std::vector<uint32_t> places_;  // [triangles] of known_
    double slack_ = 0;              // of a squared distance: more than roundings make of it
};

// Weights of the corners of t at its point nearest to p.
glm::dvec3 nearest_on(const NearestPoint::Triangle &t, glm::dvec3 p);

inline glm::dvec3 point_on(const NearestPoint::Triangle &t, glm::dvec3 weights)
{
    return weights.x * t[0] + weights.y * t[1] + weights.z * t[2];
}

}  // namespace claque::lod
