// The tree follows Box2D's b2DynamicTree and Bullet's btDbvt: a leaf goes where the boxes above it grow least (Catto
// 2019, Dynamic Bounding Volume Hierarchies). New here: reach and speed of leaves, and memory reserved beforehand.
#include "lib/scene/tree.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace claque::scene
{

using model::none;

namespace
{

constexpr double most = static_cast<double>(std::numeric_limits<float>::max());
constexpr float endless = std::numeric_limits<float>::infinity();

// Lengths of the sides: boxes round people on flat ground have no volume.
double size_of(const Box &box)
{
    double sum = 0;
    for (int k = 0; k < 3; ++k) sum += double(box.high[k]) - double(box.low[k]);
    return sum;
}

Box united(const Box &a, const Box &b)
{
    Box out;
    for (int k = 0; k < 3; ++k) {
        out.low[k] = std::min(a.low[k], b.low[k]);
        out.high[k] = std::max(a.high[k], b.high[k]);
    }
    return out;
}

bool equal(const Leaf &a, const Leaf &b)
{
    return a.box.holds(b.box) && b.box.holds(a.box) && a.reach == b.reach && a.speed == b.speed;
}

}  // namespace

float rounded_up(double x) noexcept
{
    if (x > most) return endless;
    if (x < -most) return -std::numeric_limits<float>::max();
    const float near = static_cast<float>(x);
    return double(near) < x ? std::nextafter(near, endless) : near;
}

Box box_round(const glm::dvec3 &centre, double margin) noexcept
{
    Box out;
    for (int k = 0; k < 3; ++k) {
        out.low[k] = -rounded_up(-(centre[k] - margin));
        out.high[k] = rounded_up(centre[k] + margin);
    }
    return out;
}

void Tree::reserve(uint32_t leaves)
{
    const size_t wanted = 2 * size_t(leaves);
    if (wanted <= nodes_.size()) return;
    nodes_.reserve(wanted);
    for (size_t i = nodes_.size(); i < wanted; ++i) {
        nodes_.emplace_back();
        give_back(static_cast<uint32_t>(i));
    }
}

void Tree::clear() noexcept
{
    root_ = first_free_ = none;
    is_loose_ = false;
    for (uint32_t i = static_cast<uint32_t>(nodes_.size()); i-- > 0;) give_back(i);
}

uint32_t Tree::take() noexcept
{
    const uint32_t node = first_free_;
    first_free_ = nodes_[node].parent;
    nodes_[node] = Node();
    return node;
}

void Tree::give_back(uint32_t node) noexcept
{
    nodes_[node].parent = first_free_;
    first_free_ = node;
}

// Puts a node in the place that another one has below its parent.
void Tree::replace(uint32_t parent, uint32_t node, uint32_t by) noexcept
{
    nodes_[by].parent = parent;
    if (parent == none) root_ = by;
    else nodes_[parent].child[nodes_[parent].child[1] == node] = by;
}

// The leaf below a node at which boxes grow least. Always a leaf: then one rotation a node keeps an AVL tree's balance.
uint32_t Tree::sibling_for(const Box &box, uint32_t from) const noexcept
{
    uint32_t at = from;
    while (!nodes_[at].is_leaf()) {
        double costs[2];
        for (int side = 0; side < 2; ++side) {
            const Node &child = nodes_[nodes_[at].child[side]];
            const double with = size_of(united(child.box, box));
            costs[side] = child.is_leaf() ? with : with - size_of(child.box);
        }
        at = nodes_[at].child[costs[1] < costs[0]];
    }
    return at;
}

void Tree::link(uint32_t leaf, uint32_t from) noexcept
{
    if (root_ == none) {
        root_ = leaf;
        nodes_[leaf].parent = none;
        return;
    }
    const uint32_t sibling = sibling_for(nodes_[leaf].box, from);
    const uint32_t parent = take();
    replace(nodes_[sibling].parent, sibling, parent);
    nodes_[parent].child[0] = sibling, nodes_[parent].child[1] = leaf;
    nodes_[sibling].parent = nodes_[leaf].parent = parent;
    refit(parent);
}

// Returns the lowest node that remains above it, or none.
uint32_t Tree::unlink(uint32_t leaf) noexcept
{
    const uint32_t parent = nodes_[leaf].parent;
    if (parent == none) {
        root_ = none;
        return none;
    }
    const uint32_t sibling = nodes_[parent].child[nodes_[parent].child[0] == leaf], above = nodes_[parent].parent;
    replace(above, parent, sibling);
    give_back(parent);
    refit(above);
    return nodes_[sibling].parent;
}

uint32_t Tree::insert(uint32_t row, const Leaf &leaf) noexcept
{
    const uint32_t node = take();
    static_cast<Leaf &>(nodes_[node]) = leaf;
    nodes_[node].child[1] = row;
    if (!is_loose_) link(node, root_);
    return node;
}

void Tree::erase(uint32_t node) noexcept
{
    if (!is_loose_) unlink(node);
    give_back(node);
}

void Tree::move(uint32_t node, const Leaf &leaf) noexcept
{
    if (is_loose_) {
        static_cast<Leaf &>(nodes_[node]) = leaf;
        return;
    }
    const uint32_t beside = unlink(node);
    static_cast<Leaf &>(nodes_[node]) = leaf;
    uint32_t from = beside;
    while (from != none && !nodes_[from].box.holds(leaf.box)) from = nodes_[from].parent;
    link(node, from == none ? root_ : from);
}

// Lifts one of a node's children into its place. The taller of that child's own children stays with it, the node takes
// the other.
uint32_t Tree::raise(uint32_t node, int side) noexcept
{
    const uint32_t up = nodes_[node].child[side];
    uint32_t tall = nodes_[up].child[0], low = nodes_[up].child[1];
    if (nodes_[low].height > nodes_[tall].height) std::swap(tall, low);
    replace(nodes_[node].parent, node, up);
    nodes_[up].child[0] = node, nodes_[up].child[1] = tall;
    nodes_[node].child[side] = low;
    nodes_[node].parent = nodes_[tall].parent = up;
    nodes_[low].parent = node;
    pull(node);
    return up;
}

uint32_t Tree::balance(uint32_t node) noexcept
{
    const uint32_t *child = nodes_[node].child;
    const int tilt = nodes_[child[1]].height - nodes_[child[0]].height;
    return tilt > 1 ? raise(node, 1) : tilt < -1 ? raise(node, 0) : node;
}

// Makes a node hold its children. Returns whether that changed it.
bool Tree::pull(uint32_t node) noexcept
{
    Node &at = nodes_[node];
    const Node &a = nodes_[at.child[0]], &b = nodes_[at.child[1]];
    Leaf made;
    made.box = united(a.box, b.box);
    made.reach = std::max(a.reach, b.reach);
    made.speed = std::max(a.speed, b.speed);
    const int32_t height = 1 + std::max(a.height, b.height);
    if (height == at.height && equal(made, at)) return false;
    static_cast<Leaf &>(at) = made;
    at.height = height;
    return true;
}

// Upwards, until nothing changes any more.
void Tree::refit(uint32_t node) noexcept
{
    while (node != none) {
        const uint32_t top = balance(node);
        if (!pull(top) && top == node) return;
        node = nodes_[top].parent;
    }
}

void Tree::dissolve() noexcept
{
    uint32_t waiting[max_depth];
    uint32_t count = 0;
    if (root_ != none) waiting[count++] = root_;
    while (count > 0) {
        const uint32_t at = waiting[--count];
        if (nodes_[at].is_leaf()) continue;
        for (const uint32_t child : nodes_[at].child) waiting[count++] = child;
        give_back(at);
    }
    root_ = none;
    is_loose_ = true;
}

void Tree::build(uint32_t *leaves, uint32_t count) noexcept
{
    is_loose_ = false;
    if (count == 0) return;
    root_ = join(leaves, count);
    nodes_[root_].parent = none;
}

// Halves the leaves along the axis on which they are farthest apart, so that heights differ by one at most.
uint32_t Tree::join(uint32_t *leaves, uint32_t count) noexcept
{
    if (count == 1) return leaves[0];
    Box all = nodes_[leaves[0]].box;
    for (uint32_t i = 1; i < count; ++i) all = united(all, nodes_[leaves[i]].box);
    int axis = 0;
    for (int k = 1; k < 3; ++k)
        if (all.high[k] - all.low[k] > all.high[axis] - all.low[axis]) axis = k;
    const uint32_t half = count / 2;
    std::nth_element(leaves, leaves + half, leaves + count, [&](uint32_t a, uint32_t b) {
        const Node &p = nodes_[a], &q = nodes_[b];
        return p.box.low[axis] != q.box.low[axis] ? p.box.low[axis] < q.box.low[axis] : p.row() < q.row();
    });
    const uint32_t node = take();
    const uint32_t low = join(leaves, half), high = join(leaves + half, count - half);
    nodes_[node].child[0] = low, nodes_[node].child[1] = high;
    nodes_[low].parent = nodes_[high].parent = node;
    pull(node);
    return node;
}

}  // namespace claque::scene
