#include "lib/lod/surface/aabb_tree.h"

#include <algorithm>
#include <limits>
#include <numeric>

#include <glm/common.hpp>

namespace claque::lod
{

AabbTree::AabbTree(const std::vector<Corners3> &triangles) : order(triangles.size())
{
    std::iota(order.begin(), order.end(), 0u);
    boxes.reserve(std::max<size_t>(1, triangles.size()));  // a leaf has two at least, if there are two
    boxes.push_back({{}, {}, 0, static_cast<uint32_t>(order.size()), 0});
    for (uint32_t box = 0; box < boxes.size(); ++box) split(triangles, box);
}

AabbTree::Descendants AabbTree::below(const Box &box) const
{
    Descendants found;
    for (const uint32_t child : {box.left, box.left + 1}) {
        const uint32_t left = boxes[child].left;
        if (!left) found.boxes[found.count++] = child;
        else found.boxes[found.count++] = left, found.boxes[found.count++] = left + 1;
    }
    return found;
}

void AabbTree::split(const std::vector<Corners3> &triangles, uint32_t box)
{
    glm::dvec3 min(std::numeric_limits<double>::infinity()), max = -min;
    const uint32_t begin = boxes[box].begin, end = boxes[box].end;
    for (uint32_t i = begin; i < end; ++i)
        for (const glm::dvec3 corner : triangles[order[i]]) min = glm::min(min, corner), max = glm::max(max, corner);
    boxes[box].min = min, boxes[box].max = max;
    if (end - begin <= 4) return;
    const glm::dvec3 size = max - min;
    const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    const auto middle_of = [&](uint32_t t) {
        return triangles[t][0][axis] + triangles[t][1][axis] + triangles[t][2][axis];
    };
    const uint32_t half = (begin + end) / 2;
    std::nth_element(order.begin() + begin, order.begin() + half, order.begin() + end, [&](uint32_t a, uint32_t b) {
        const double at_a = middle_of(a), at_b = middle_of(b);
        return at_a != at_b ? at_a < at_b : a < b;
    });
    boxes[box].left = static_cast<uint32_t>(boxes.size());
    boxes.push_back({{}, {}, begin, half, 0});
    boxes.push_back({{}, {}, half, end, 0});
}

}  // namespace claque::lod
