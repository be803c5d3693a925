// A tree of bounding boxes over triangles, with at most four triangles a leaf. Internal to lib/lod.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include <glm/vec3.hpp>

namespace claque::lod
{

using Corners3 = std::array<glm::dvec3, 3>;

struct AabbTree {
    explicit AabbTree(const std::vector<Corners3> &triangles);  // at least one triangle

    struct Box {
        glm::dvec3 min, max;
        uint32_t begin = 0, end = 0;  // range of `order`
        uint32_t left = 0;            // the children are `left` and `left + 1`; 0: a leaf
    };
    // Two levels below a box that is no leaf, or one where that is a leaf.
    struct Descendants {
        std::array<uint32_t, 4> boxes;
        size_t count = 0;
    };
    Descendants below(const Box &box) const;

    std::vector<uint32_t> order;
    std::vector<Box> boxes;  // the root is first

private:
    void split(const std::vector<Corners3> &triangles, uint32_t box);
};

}  // namespace claque::lod
