// Triangles in a tree of boxes, of up to four a leaf. Between the files of this room only.
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

namespace claque::lod
{

using Corners3 = std::array<glm::dvec3, 3>;

struct AabbTree {
    explicit AabbTree(const std::vector<Corners3> &triangles);  // at least one

    struct Box {
        glm::dvec3 min, max;
        uint32_t begin = 0, end = 0;  // of order
        uint32_t left = 0;            // children left and left + 1; 0: a leaf
    };
    std::vector<uint32_t> order;
    std::vector<Box> boxes;  // the root first

private:
    void split(const std::vector<Corners3> &triangles, uint32_t box);
};

}  // namespace claque::lod
