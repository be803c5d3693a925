#include "samples/scenes/blocks.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

namespace scenes
{
namespace
{

using Cell = std::tuple<int, int, int>;

Cell cell_of(Vec3 p, float block_m)
{
    const auto at = [&](float x) { return static_cast<int>(std::floor(x / block_m)); };
    return {at(p.x), at(p.y), at(p.z)};
}

// Of the vertices that some indices name.
struct Box {
    Vec3 low = {1e30f, 1e30f, 1e30f}, high = {-1e30f, -1e30f, -1e30f};

    void enclose(const Geometry &g, const Blocks::Span &span)
    {
        for (uint32_t i = span.first; i < span.first + span.count; ++i) {
            const Vec3 p = g.vertices()[g.indices()[i]].position;
            low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
            high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
        }
    }
    Vec3 middle() const { return {(low.x + high.x) / 2, (low.y + high.y) / 2, (low.z + high.z) / 2}; }
    Sphere sphere() const
    {
        const float x = high.x - low.x, y = high.y - low.y, z = high.z - low.z;
        return {middle(), 0.500001f * std::sqrt(x * x + y * y + z * z)};
    }
};

// Copies triangles. Vertices lie in the order in which blocks use them.
class Mover
{
public:
    Mover(const Geometry &from, Geometry &to) : from_(from), to_(to), moved_(from.vertices().size(), UINT32_MAX) {}

    template <class Change>
    void move(const Blocks::Span &span, Change change)
    {
        for (uint32_t i = span.first; i < span.first + span.count; i += 3) {
            uint32_t corners[3];
            for (uint32_t k = 0; k < 3; ++k) {
                const uint32_t vertex = from_.indices()[i + k];
                if (moved_[vertex] == UINT32_MAX) moved_[vertex] = to_.add(change(from_.vertices()[vertex]));
                corners[k] = moved_[vertex];
            }
            to_.triangle(corners[0], corners[1], corners[2]);
        }
    }
    uint32_t done() const { return static_cast<uint32_t>(to_.indices().size()); }

private:
    const Geometry &from_;
    Geometry &to_;
    std::vector<uint32_t> moved_;
};

SceneryVertex as_it_is(const SceneryVertex &vertex) { return vertex; }

// The square of the distance from a point to a box.
double distance2(const Blocks::Block &block, const double (&eye)[3])
{
    const double low[] = {double(block.low.x), double(block.low.y), double(block.low.z)};
    const double high[] = {double(block.high.x), double(block.high.y), double(block.high.z)};
    double sum = 0;
    for (int k = 0; k < 3; ++k) {
        const double out = std::max({low[k] - eye[k], eye[k] - high[k], 0.0});
        sum += out * out;
    }
    return sum;
}

}  // namespace

Blocks::Blocks(const Geometry &whole, float block_m)
{
    std::map<Cell, std::vector<Span>> cells;
    for (uint32_t i = 0; i < whole.indices().size(); i += 3) {
        Vec3 sum = {0, 0, 0};
        for (uint32_t k = 0; k < 3; ++k) {
            const Vec3 p = whole.vertices()[whole.indices()[i + k]].position;
            sum = {sum.x + p.x / 3, sum.y + p.y / 3, sum.z + p.z / 3};
        }
        cells[cell_of(sum, block_m)].push_back({i, 3});
    }
    Mover mover(whole, fine_);
    for (const auto &[cell, triangles] : cells) {
        Box box;
        const uint32_t first = mover.done();
        for (const Span &span : triangles) mover.move(span, as_it_is), box.enclose(whole, span);
        blocks_.push_back({box.low, box.high, box.sphere(), {}, {first, mover.done() - first}, {}});
    }
}

Blocks::Blocks(const Parts &parts, float block_m, const Far &far) : far_m_(far.from_m)
{
    std::map<Cell, std::vector<Parts::Part>> cells;
    for (const Parts::Part &part : parts.all()) {
        Box box;
        box.enclose(parts.fine, part.fine);
        cells[cell_of(box.middle(), block_m)].push_back(part);
    }
    Mover fine(parts.fine, fine_), coarse(parts.coarse, coarse_);
    const auto in_the_light = [&](SceneryVertex vertex) {
        shine(far.light, vertex, far.texel);
        return vertex;
    };
    for (const auto &[cell, members] : cells) {
        Box box;
        Block block = {{}, {}, {}, {fine.done(), 0}, {}, {coarse.done(), 0}};
        for (const bool with_coarse : {true, false}) {
            for (const Parts::Part &part : members) {
                box.enclose(parts.fine, part.fine);
                if ((part.coarse.count > 0) != with_coarse) continue;
                fine.move(part.fine, as_it_is);
                coarse.move(part.coarse, in_the_light);
                box.enclose(parts.coarse, part.coarse);
            }
            if (with_coarse) block.near.count = fine.done() - block.near.first;
        }
        block.any = {block.near.first + block.near.count, fine.done() - block.near.first - block.near.count};
        block.far.count = coarse.done() - block.far.first;
        block.low = box.low, block.high = box.high, block.sphere = box.sphere();
        blocks_.push_back(block);
    }
}

void Blocks::choose(const Frustum *cull, const double (&eye)[3], Choice &choice) const
{
    choice.order.clear();
    for (uint32_t i = 0; i < blocks_.size(); ++i)
        if (!cull || cull->meets(blocks_[i].sphere)) choice.order.emplace_back(distance2(blocks_[i], eye), i);
    std::sort(choice.order.begin(), choice.order.end());
    choice.fine.clear(), choice.coarse.clear();
    const auto add = [](std::vector<uint32_t> &list, const Geometry &g, const Span &span) {
        const auto first = g.indices().begin() + span.first;
        list.insert(list.end(), first, first + span.count);
    };
    for (const auto &[distance, i] : choice.order) {
        const Block &block = blocks_[i];
        const bool is_far = distance >= double(far_m_) * double(far_m_);
        if (is_far) add(choice.coarse, coarse_, block.far);
        else add(choice.fine, fine_, block.near);
        add(choice.fine, fine_, block.any);
    }
}

void Blocks::draw(const Gl &g, const Eye &eye, const Frustum *cull) const
{
    choose(cull, eye.position, chosen_);
    fine_.draw(g, chosen_.fine);
    if (chosen_.coarse.empty()) return;
    g.Disable(gl::texture_2d);
    g.Disable(gl::lighting);
    coarse_.draw(g, chosen_.coarse);
    g.Enable(gl::lighting);
}

}  // namespace scenes
