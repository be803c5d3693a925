#include "samples/scenes/town/pieces.h"

#include <algorithm>
#include <cmath>

namespace scenes::town
{
namespace
{

Sphere sphere_of(const std::vector<Geometry> &layers, const std::vector<Span> &spans)
{
    Vec3 low = {1e30f, 1e30f, 1e30f}, high = {-1e30f, -1e30f, -1e30f};
    const auto each = [&](auto &&visit) {
        for (const Span &span : spans) {
            const Geometry &g = layers[static_cast<size_t>(span.layer)];
            for (uint32_t i = span.first; i < span.first + span.count; ++i)
                visit(g.vertices()[g.indices()[i]].position);
        }
    };
    each([&](Vec3 p) {
        low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
        high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
    });
    const Vec3 middle = {(low.x + high.x) / 2, (low.y + high.y) / 2, (low.z + high.z) / 2};
    double largest = 0;
    each([&](Vec3 p) {
        const double x = static_cast<double>(p.x) - middle.x, y = static_cast<double>(p.y) - middle.y;
        const double z = static_cast<double>(p.z) - middle.z;
        largest = std::max(largest, x * x + y * y + z * z);
    });
    return {middle, static_cast<float>(std::sqrt(largest) * 1.000001)};
}

}  // namespace

Pieces::Pieces(const std::array<float, surface_kind_count> &texture_metres)
{
    for (const float metres : texture_metres) layers_.emplace_back(metres);
}

void Pieces::from_now(Visibility seen)
{
    for (size_t i = 0; i < surface_kind_count; ++i) {
        const uint32_t now = static_cast<uint32_t>(layers_[i].indices().size());
        if (now > done_[i]) open_.push_back({static_cast<SurfaceKind>(i), visibility_, done_[i], now - done_[i]});
        done_[i] = now;
    }
    visibility_ = seen;
}

void Pieces::finish(Piece::Kind kind)
{
    from_now(Visibility::always);
    if (open_.empty()) return;
    pieces_.push_back({kind, sphere_of(layers_, open_), open_});
    open_.clear();
}

size_t Pieces::triangles() const
{
    size_t sum = 0;
    for (const Geometry &g : layers_) sum += g.indices().size() / 3;
    return sum;
}

size_t Pieces::choose(const Frustum *cull, const double (&eye)[3], Choice &choice) const
{
    for (std::vector<uint32_t> &indices : choice.indices) indices.clear();
    choice.order.clear();
    for (uint32_t i = 0; i < pieces_.size(); ++i) {
        const Sphere &sphere = pieces_[i].sphere;
        if (cull && !cull->meets(sphere)) continue;
        const double x = static_cast<double>(sphere.centre.x) - eye[0],
                     y = static_cast<double>(sphere.centre.y) - eye[1];
        const double z = static_cast<double>(sphere.centre.z) - eye[2];
        choice.order.emplace_back(std::sqrt(x * x + y * y + z * z) - static_cast<double>(sphere.radius), i);
    }
    std::sort(choice.order.begin(), choice.order.end());  // the nearest first, so that GL paints few pixels twice
    for (const auto &[distance, i] : choice.order) {
        const Visibility hidden = distance < static_cast<double>(near_m) ? Visibility::far : Visibility::near;
        for (const Span &span : pieces_[i].spans) {
            if (span.seen == hidden) continue;
            const size_t layer = static_cast<size_t>(span.layer);
            const auto first = layers_[layer].indices().begin() + span.first;
            choice.indices[layer].insert(choice.indices[layer].end(), first, first + span.count);
        }
    }
    size_t sum = 0;
    for (const std::vector<uint32_t> &indices : choice.indices) sum += indices.size() / 3;
    return sum;
}

void Pieces::draw(const Gl &g, SurfaceKind layer, const Choice &choice) const
{
    on(layer).draw(g, choice.indices[static_cast<size_t>(layer)]);
}

}  // namespace scenes::town
