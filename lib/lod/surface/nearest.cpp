#include "lib/lod/surface/nearest.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "lib/lod/surface/four.h"

namespace claque::lod
{

namespace
{

// A bound far above the error of coordinates of at most 1 after a few float operations.
constexpr double float_error = 2e-6;
constexpr uint32_t no_index = 0xffffffff;

// A search in progress: triangles whose distance in floats is above `limit` are skipped, the others are measured in
// doubles.
struct Search {
    Search(glm::dvec3 p, const FloatFrame &frame) : point(p), scale(frame.scale)
    {
        const glm::dvec3 here = scale * (p - frame.centre), away = glm::abs(here);
        at = splat(here), error = float_error * (1 + std::max({away.x, away.y, away.z}));
    }
    void try_triangle(const PrecomputedTriangle &t, uint32_t index)
    {
        const glm::dvec3 w = t.nearest(point), off = point_on(t.corners, w) - point;
        const double square = glm::dot(off, off);
        if (!(square < least || (square == least && index < best))) return;
        best = index, weights = w, least = square;
        const double reach = (1 + 1e-5) * scale * std::sqrt(square) + error;
        limit = static_cast<float>(std::min(reach * reach * (1 + 1e-6), 3e38));
    }
    // Tries those of a block; `begin`: the index of its first triangle, which is `triangles[begin]`.
    void try_block(const TriangleBlock &block, const std::vector<PrecomputedTriangle> &triangles, uint32_t begin,
                   uint32_t end, uint32_t tried = no_index)
    {
        const math::F4 squares = block.distances_squared(at, math::splat(float(error)));
        for (uint32_t i = begin; i < end; ++i)
            if (squares[i - begin] <= limit && i != tried) try_triangle(triangles[i], i);
    }
    // Where the point is too far away for floats.
    void try_all(const std::vector<PrecomputedTriangle> &triangles)
    {
        for (uint32_t i = 0; i < triangles.size(); ++i) try_triangle(triangles[i], i);
    }

    glm::dvec3 point;
    double scale, error = 0;
    Four3 at{};
    uint32_t best = no_index;
    glm::dvec3 weights = glm::dvec3(0);
    double least = std::numeric_limits<double>::infinity();
    float limit = 3e38f;
};

}  // namespace

FloatFrame::FloatFrame(glm::dvec3 min, glm::dvec3 max) : centre(0.5 * (min + max))
{
    const glm::dvec3 half = max - centre;
    scale = 1 / std::max({half.x, half.y, half.z, 1e-150});
}

PrecomputedTriangle::PrecomputedTriangle(const Corners3 &t)
    : corners(t),
      edges{t[1] - t[0], t[2] - t[1], t[0] - t[2]},
      normal(glm::cross(t[1] - t[0], t[2] - t[0])),
      square(glm::dot(normal, normal))
{
    for (size_t i = 0; i < 3; ++i) squares[i] = glm::dot(edges[i], edges[i]);
}

glm::dvec3 PrecomputedTriangle::nearest(glm::dvec3 p) const
{
    const Corners3 &c = corners, &e = edges;
    const Corners3 to = {p - c[0], p - c[1], p - c[2]};
    if (square > 0) {
        const glm::dvec3 w(glm::dot(glm::cross(e[1], to[1]), normal) / square,
                           glm::dot(glm::cross(e[2], to[2]), normal) / square,
                           glm::dot(glm::cross(e[0], to[0]), normal) / square);
        if (w.x >= 0 && w.y >= 0 && w.z >= 0) return w / (w.x + w.y + w.z);
    }
    glm::dvec3 best(1, 0, 0);
    double least = std::numeric_limits<double>::infinity();
    for (int k = 0; k < 3; ++k) {
        const size_t from = static_cast<size_t>(k), next = (from + 1) % 3;
        const double part = squares[from] > 0 ? std::clamp(glm::dot(to[from], e[from]) / squares[from], 0.0, 1.0) : 0.0;
        const glm::dvec3 off = (1 - part) * c[from] + part * c[next] - p;
        if (const double here = glm::dot(off, off); here < least) {
            least = here;
            best = glm::dvec3(0);
            best[k] = 1 - part, best[static_cast<int>(next)] = part;
        }
    }
    return best;
}

TriangleBlock::TriangleBlock(const PrecomputedTriangle *triangles, size_t count, const FloatFrame &frame)
{
    const double scale = frame.scale;
    for (size_t lane = 0; lane < 4; ++lane) {
        const PrecomputedTriangle &t = triangles[std::min(lane, count - 1)];
        const double longest = std::max({t.squares[0], t.squares[1], t.squares[2]});
        const bool is_needle = !(t.square > 1e-8 * longest * longest);
        const glm::dvec3 normal = is_needle ? glm::dvec3(0) : t.normal / std::sqrt(t.square);
        set(normal_, lane, normal);
        nothing_inside_[lane] = t.square > 0 ? 0.0f : -1e30f;
        for (size_t k = 0; k < 3; ++k) {
            const glm::dvec3 edge = scale * t.edges[k];
            const double length = glm::length(edge);
            set(corners_[k], lane, scale * (t.corners[k] - frame.centre)), set(edges_[k], lane, edge);
            set(inward_[k], lane, length > 0 ? glm::cross(normal, edge) / length : glm::dvec3(0));
            inverse_squares_[k][lane] = static_cast<float>(1 / std::max(length * length, 1e-30));
        }
    }
}

// The distance from the plane where the point is above the triangle, or may be; else from the nearest edge.
math::F4 TriangleBlock::distances_squared(const std::array<math::F4, 3> &p, math::F4 rounding) const
{
    const math::F4 zero = math::splat(0), one = math::splat(1);
    math::F4 edge = math::splat(3e38f), inside = math::splat(3e38f);
    for (size_t k = 0; k < 3; ++k) {
        const Four3 to = minus(p, corners_[k]);
        inside = smaller(inside, dot(inward_[k], to));
        const math::F4 along = smaller(larger(dot(to, edges_[k]) * inverse_squares_[k], zero), one);
        const Four3 off = {to[0] - along * edges_[k][0], to[1] - along * edges_[k][1], to[2] - along * edges_[k][2]};
        edge = smaller(edge, dot(off, off));
    }
    const math::F4 plane = dot(normal_, minus(p, corners_[0])), above = plane * plane;
    return inside + nothing_inside_ >= -rounding ? above : edge;
}

NearestPoint::NearestPoint(const std::vector<Triangle> &triangles) : slots_(triangles.size())
{
    AabbTree tree(triangles);
    order_ = std::move(tree.order);
    triangles_.reserve(order_.size());
    for (const uint32_t t : order_) {
        slots_[t] = static_cast<uint32_t>(triangles_.size());
        triangles_.emplace_back(triangles[t]);
    }
    frame_ = {tree.boxes[0].min, tree.boxes[0].max};
    leaves_.reserve((tree.boxes.size() + 1) / 2), nodes_.reserve(tree.boxes.size() / 2);
    root_ = add(tree, 0);
}

uint32_t NearestPoint::add(const AabbTree &tree, uint32_t box)
{
    const AabbTree::Box &from = tree.boxes[box];
    if (!from.left) {
        leaves_.push_back({{&triangles_[from.begin], from.end - from.begin, frame_}, from.begin, from.end});
        return static_cast<uint32_t>(leaves_.size() - 1) | leaf_bit;
    }
    const auto [children, count] = tree.below(from);
    const size_t at = nodes_.size();
    nodes_.emplace_back();
    for (size_t i = 0; i < 4; ++i) {
        const AabbTree::Box &of = tree.boxes[children[std::min(i, count - 1)]];
        set(nodes_[at].min, i, frame_.scale * (of.min - frame_.centre));
        set(nodes_[at].max, i, frame_.scale * (of.max - frame_.centre));
        const uint32_t child = i < count ? add(tree, children[i]) : none;
        nodes_[at].child[i] = child;
    }
    return static_cast<uint32_t>(at);
}

// Boxes are skipped as triangles are.
NearestPoint::Found NearestPoint::to(glm::dvec3 p, uint32_t guess) const
{
    Search search(p, frame_);
    const uint32_t tried = guess < slots_.size() ? slots_[guess] : no_index;
    if (tried != no_index) search.try_triangle(triangles_[tried], tried);
    struct Open {
        uint32_t node;
        float square;
    };
    std::array<Open, 64> open;  // the tree quarters its range: at most 16 levels with three siblings each, and four
    size_t count = 0;
    open[count++] = {root_, 0};
    while (count) {
        const Open next = open[--count];
        if (next.square > search.limit) continue;
        if (next.node & leaf_bit) {
            const Leaf &leaf = leaves_[next.node & ~leaf_bit];
            search.try_block(leaf.block, triangles_, leaf.begin, leaf.end, tried);
            continue;
        }
        const Node &node = nodes_[next.node];
        math::F4 squares = math::splat(0);
        for (size_t k = 0; k < 3; ++k) {
            const math::F4 outside =
                larger(larger(node.min[k] - search.at[k], search.at[k] - node.max[k]), math::splat(0));
            squares += outside * outside;
        }
        const size_t first = count;  // the nearest goes on top
        for (size_t i = 0; i < 4; ++i) {
            if (node.child[i] == none || squares[i] > search.limit) continue;
            size_t k = count++;
            for (; k > first && open[k - 1].square < squares[i]; --k) open[k] = open[k - 1];
            open[k] = {node.child[i], squares[i]};
        }
    }
    if (search.best == no_index) search.try_all(triangles_);
    return {order_[search.best], search.weights, search.least};
}

FewTriangles::FewTriangles(const std::vector<Corners3> &triangles)
{
    if (triangles.empty()) return;
    glm::dvec3 min = triangles[0][0], max = min;
    triangles_.reserve(triangles.size()), blocks_.reserve((triangles.size() + 3) / 4);
    for (const Corners3 &t : triangles) {
        for (const glm::dvec3 corner : t) min = glm::min(min, corner), max = glm::max(max, corner);
        triangles_.emplace_back(t);
    }
    frame_ = {min, max};
    for (size_t i = 0; i < triangles_.size(); i += 4)
        blocks_.emplace_back(&triangles_[i], std::min<size_t>(4, triangles_.size() - i), frame_);
}

NearestPoint::Found FewTriangles::to(glm::dvec3 p) const
{
    Search search(p, frame_);
    const auto count = static_cast<uint32_t>(triangles_.size());
    for (uint32_t begin = 0; begin < count; begin += 4)
        search.try_block(blocks_[begin / 4], triangles_, begin, std::min(begin + 4, count));
    if (search.best == no_index) search.try_all(triangles_);
    return {search.best == no_index ? 0 : search.best, search.weights, search.least};
}

}  // namespace claque::lod
