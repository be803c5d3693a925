// A dynamic tree of boxes round points, the spatial index of a scene. Boxes may be larger than what they hold, so that
// small moves change nothing. Each node also bounds how far the spheres of its leaves reach round their points, and how
// fast the points move by themselves. Rotations keep it balanced, as an AVL tree.
//
// Only `reserve` allocates. The tree's shape depends on the history of calls; which leaves a box test enters does not
// decide any answer, because every leaf found is then tested exactly.
#pragma once

#include <glm/vec3.hpp>

#include "lib/model/rig.h"

namespace claque::scene
{

// Single precision, rounded outwards: half the memory, and a node fits a cache line.
struct Box {
    float low[3] = {0, 0, 0}, high[3] = {0, 0, 0};

    bool holds(const Box &other) const
    {
        for (int k = 0; k < 3; ++k)
            if (!(low[k] <= other.low[k] && other.high[k] <= high[k])) return false;
        return true;
    }
};

Box box_round(const glm::dvec3 &centre, double margin) noexcept;
float rounded_up(double x) noexcept;

struct Leaf {
    Box box;
    float reach = 0;  // of the sphere from the point, world units
    float speed = 0;  // world units a second
};

class Tree
{
public:
    static constexpr uint32_t max_depth = 64;  // of an AVL tree with 2^28 leaves: 42

    struct Node : Leaf {
        uint32_t parent = model::none;                   // of a free node: the next free one
        uint32_t child[2] = {model::none, model::none};  // of a leaf: none, and its row
        int32_t height = 0;

        bool is_leaf() const { return child[0] == model::none; }
        uint32_t row() const { return child[1]; }
    };

    explicit Tree(std::pmr::memory_resource *memory) : nodes_(memory) {}

    void reserve(uint32_t leaves);  // throws std::bad_alloc and changes nothing then
    void clear() noexcept;
    uint32_t insert(uint32_t row, const Leaf &leaf) noexcept;  // returns its node
    void erase(uint32_t node) noexcept;
    // Changes a leaf, which keeps its node. The search for a new place begins near the old one.
    void move(uint32_t node, const Leaf &leaf) noexcept;

    // Between these two calls leaves are made, changed and ended without a tree above them; `leaves` are the nodes of
    // all. A tree that is built has boxes that hardly overlap; thousands of single steps wear that off.
    void dissolve() noexcept;
    void build(uint32_t *leaves, uint32_t count) noexcept;

    bool empty() const { return root_ == model::none; }
    bool is_loose() const { return is_loose_; }  // between dissolve and build
    uint32_t root() const { return root_; }
    const Node &node(uint32_t i) const { return nodes_[i]; }
    uint32_t height() const { return empty() ? 0 : static_cast<uint32_t>(nodes_[root_].height); }
    uint64_t bytes() const { return nodes_.capacity() * sizeof(Node); }

    // Calls body(row) for all leaves under nodes that `enters` lets through, which gets each node with its bounds.
    template <class Enters, class Body>
    void for_each(const Enters &enters, const Body &body) const
    {
        if (empty()) return;
        uint32_t waiting[max_depth];
        uint32_t count = 0;
        waiting[count++] = root_;
        while (count > 0) {
            const Node &at = nodes_[waiting[--count]];
            if (!enters(at)) continue;
            if (at.is_leaf()) body(at.row());
            else waiting[count++] = at.child[0], waiting[count++] = at.child[1];
        }
    }

    // The same in the order of `distance`, which gives a lower bound for the leaves under a node, near ones first.
    // Nodes beyond `limit` are left out; body may lower it.
    template <class Distance, class Body>
    void for_each_by_distance(const Distance &distance, const double &limit, const Body &body) const
    {
        struct Waiting {
            uint32_t node;
            double distance;
        };
        if (empty()) return;
        Waiting waiting[max_depth];
        uint32_t count = 0;
        waiting[count++] = {root_, distance(nodes_[root_])};
        while (count > 0) {
            const Waiting next = waiting[--count];
            if (!(next.distance <= limit)) continue;
            const Node &at = nodes_[next.node];
            if (at.is_leaf()) {
                body(at.row());
                continue;
            }
            Waiting a = {at.child[0], distance(nodes_[at.child[0]])}, b = {at.child[1], distance(nodes_[at.child[1]])};
            if (a.distance < b.distance) std::swap(a, b);
            waiting[count++] = a, waiting[count++] = b;
        }
    }

private:
    uint32_t take() noexcept;
    void give_back(uint32_t node) noexcept;
    void replace(uint32_t parent, uint32_t node, uint32_t by) noexcept;
    uint32_t sibling_for(const Box &box, uint32_t from) const noexcept;
    void link(uint32_t leaf, uint32_t from) noexcept;
    uint32_t unlink(uint32_t leaf) noexcept;
    uint32_t raise(uint32_t node, int side) noexcept;
    uint32_t balance(uint32_t node) noexcept;
    bool pull(uint32_t node) noexcept;
    void refit(uint32_t node) noexcept;
    uint32_t join(uint32_t *leaves, uint32_t count) noexcept;

    model::Array<Node> nodes_;
    uint32_t root_ = model::none, first_free_ = model::none;
    bool is_loose_ = false;
};
static_assert(sizeof(Tree::Node) == 48, "a node fits a cache line");

}  // namespace claque::scene
