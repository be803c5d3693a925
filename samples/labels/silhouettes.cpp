#include "samples/labels/silhouettes.h"

#include <algorithm>
#include <cmath>

namespace labels
{
namespace
{

bool overlap(const Box &a, const Box &b)
{
    // One pixel between them: GL rounds.
    return std::floor(a.x0) - 1 < std::ceil(b.x1) && std::floor(b.x0) - 1 < std::ceil(a.x1) &&
           std::floor(a.y0) - 1 < std::ceil(b.y1) && std::floor(b.y0) - 1 < std::ceil(a.y1);
}

}  // namespace

std::vector<std::vector<uint32_t>> groups_apart(const std::vector<Box> &boxes)
{
    // Large boxes first: they fit with few others.
    std::vector<uint32_t> order;
    for (uint32_t i = 0; i < boxes.size(); ++i)
        if (!boxes[i].empty()) order.push_back(i);
    const auto area = [&](uint32_t i) { return (boxes[i].x1 - boxes[i].x0) * (boxes[i].y1 - boxes[i].y0); };
    std::stable_sort(order.begin(), order.end(), [&](uint32_t a, uint32_t b) { return area(a) > area(b); });
    std::vector<std::vector<uint32_t>> groups;
    for (const uint32_t one : order) {
        const auto fits = [&](const std::vector<uint32_t> &group) {
            return std::none_of(group.begin(), group.end(),
                                [&](uint32_t other) { return overlap(boxes[one], boxes[other]); });
        };
        const auto group = std::find_if(groups.begin(), groups.end(), fits);
        if (group != groups.end()) group->push_back(one);
        else groups.push_back({one});
    }
    return groups;
}

}  // namespace labels
