// The nearest of many points, by a tree of boxes.
#pragma once

#include "lib/lod/surface/aabb_tree.h"

namespace claque::lod
{

class PointTree
{
public:
    explicit PointTree(const std::vector<glm::dvec3> &points);  // at least one

    struct Found {
        uint32_t point = 0;
        double distance_squared = 0;
    };
    // The first in the tree's order wins among equally near points.
    Found to(glm::dvec3 p) const;

    static constexpr uint64_t bytes_of_point =
        sizeof(glm::dvec3) + sizeof(AabbTree::Box) + sizeof(uint32_t);  // at most

private:
    std::vector<glm::dvec3> points_;  // in tree order
    AabbTree tree_;
};

}  // namespace claque::lod
