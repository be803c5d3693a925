#include "lib/asset/areas/box_tree.h"

#include <numeric>

namespace claque::asset
{

namespace
{

std::vector<Point> middles_of(const std::vector<Box> &boxes)
{
    std::vector<Point> out;
    out.reserve(boxes.size());
    for (const Box &box : boxes) out.push_back(box.middle());
    return out;
}

}  // namespace

BoxTree::BoxTree(const std::vector<Point> &places) : node_of_(places.size())
{
    if (places.empty()) return;
    size_t leaves = 1;
    while (leaves < places.size()) leaves *= 2;
    nodes_.resize(2 * leaves);
    std::vector<uint32_t> items(places.size());
    std::iota(items.begin(), items.end(), 0u);
    halve(places, items.data(), items.data() + items.size(), 1);
}

BoxTree::BoxTree(const std::vector<Box> &boxes) : BoxTree(middles_of(boxes))
{
    for (size_t i = 0; i < boxes.size(); ++i) nodes_[node_of_[i]].box = boxes[i];
    for (uint32_t node = static_cast<uint32_t>(nodes_.size() / 2); node-- > 1;)
        if (nodes_[node].item == inner) join_children(node);
}

void BoxTree::halve(const std::vector<Point> &places, uint32_t *first, uint32_t *last, uint32_t node)
{
    if (last - first == 1) {
        nodes_[node].item = *first, node_of_[*first] = node;
        return;
    }
    Box around;
    for (const uint32_t *item = first; item != last; ++item) around.add(places[*item]);
    const bool wide = around.high.x - around.low.x > around.high.y - around.low.y;
    uint32_t *const middle = first + (last - first) / 2;
    std::nth_element(first, middle, last, [&](uint32_t a, uint32_t b) {
        const double at = wide ? places[a].x : places[a].y, other = wide ? places[b].x : places[b].y;
        return at < other || (at == other && a < b);
    });
    halve(places, first, middle, 2 * node);
    halve(places, middle, last, 2 * node + 1);
}

bool BoxTree::join_children(uint32_t node)
{
    Box joined = nodes_[2 * node].box;
    joined.add(nodes_[2 * node + 1].box);
    Box &box = nodes_[node].box;
    if (same(box.low, joined.low) && same(box.high, joined.high)) return false;
    box = joined;
    return true;
}

void BoxTree::set(uint32_t item, const Box &box)
{
    uint32_t node = node_of_[item];
    nodes_[node].box = box;
    while ((node /= 2) > 0)
        if (!join_children(node)) return;
}

}  // namespace claque::asset
