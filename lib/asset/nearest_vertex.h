// Finds the nearest of some vertices, by a k-d tree.
#pragma once

#include <cstdint>
#include <vector>

#include <glm/vec3.hpp>

namespace claque::asset
{

class NearestVertex
{
public:
    // `among`: indices of positions, which must live as long as this; one at least.
    NearestVertex(const std::vector<glm::vec3> &positions, std::vector<uint32_t> among);

    // The index of the nearest. Where the most of the tree is about equally far, one that is nearly as near: a search
    // looks at a limited number, so that no file makes it slow.
    uint32_t to(const glm::vec3 &place) const;

private:
    struct Search;
    void split(size_t first, size_t last, int axis);
    void search(size_t first, size_t last, int axis, Search &of) const;

    const std::vector<glm::vec3> &positions_;
    std::vector<uint32_t> tree_;  // of each range, the middle one divides the others
};

}  // namespace claque::asset
