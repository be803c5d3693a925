// Boxes in a binary tree, so that a search for those at a place looks at few others.
#pragma once

#include <cstdint>
#include <vector>

#include "lib/asset/areas/box.h"

namespace claque::asset
{

// The order of the boxes depends on their places alone.
class BoxTree
{
public:
    BoxTree() = default;
    // Items at these places; their boxes are empty at first.
    explicit BoxTree(const std::vector<Point> &places);
    explicit BoxTree(const std::vector<Box> &boxes);

    const Box &box(uint32_t item) const { return nodes_[node_of_[item]].box; }
    void set(uint32_t item, const Box &box);

    // Whether `take` is true of an item whose box `meets` is true of; the others are then left out. `meets` is asked of
    // the boxes round several items, too; what is near `from` comes first, so that it may ask for less and less.
    template <class Meets, class Take>
    bool any(const Point &from, const Meets &meets, const Take &take) const
    {
        return !nodes_.empty() && any_below(1, from, meets, take);
    }

private:
    static constexpr uint32_t inner = 0xffffffffu;

    struct Node {
        Box box;
        uint32_t item = inner;
    };

    // Halves items along the longer side of the box round their places, and each half again.
    void halve(const std::vector<Point> &places, uint32_t *first, uint32_t *last, uint32_t node);
    bool join_children(uint32_t node);  // whether its box is another than before

    template <class Meets, class Take>
    bool any_below(uint32_t node, const Point &from, const Meets &meets, const Take &take) const
    {
        if (!meets(nodes_[node].box)) return false;
        if (nodes_[node].item != inner) return take(nodes_[node].item);
        const uint32_t child = 2 * node;
        const uint32_t near = child + (nodes_[child + 1].box.distance(from) < nodes_[child].box.distance(from));
        return any_below(near, from, meets, take) || any_below(near ^ 1, from, meets, take);
    }

    std::vector<Node> nodes_;  // the children of node i are 2 i and 2 i + 1; the root is 1
    std::vector<uint32_t> node_of_;
};

}  // namespace claque::asset
