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

Frustum::Frustum(const Eye &eye, float scale)
{
    double m[4][4];  // rows of projection times view
    for (size_t row = 0; row < 4; ++row)
        for (size_t column = 0; column < 4; ++column) {
            m[row][column] = 0;
            for (size_t k = 0; k < 4; ++k)
                m[row][column] += static_cast<double>(eye.projection[4 * k + row]) * eye.view[4 * column + k];
        }
    for (size_t plane = 0; plane < 6; ++plane) {
        const size_t axis = plane / 2;
        const double side = plane % 2 == 0 ? 1 : -1, wide = axis < 2 ? static_cast<double>(scale) : 1.0;
        double p[4], length = 0;
        for (size_t k = 0; k < 4; ++k) p[k] = wide * m[3][k] + side * m[axis][k];
        for (size_t k = 0; k < 3; ++k) length += p[k] * p[k];
        for (size_t k = 0; k < 4; ++k) planes_[plane][k] = static_cast<float>(p[k] / std::sqrt(length));
    }
}

bool Frustum::meets(const Sphere &s) const
{
    for (const std::array<float, 4> &p : planes_)
        if (p[0] * s.centre.x + p[1] * s.centre.y + p[2] * s.centre.z + p[3] < -s.radius) return false;
    return true;
}

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
    for (std::vector<uint32_t> &indices : choice) indices.clear();
    for (const Piece &piece : pieces_) {
        if (cull && !cull->meets(piece.sphere)) continue;
        const Vec3 &c = piece.sphere.centre;
        const double x = static_cast<double>(c.x) - eye[0], y = static_cast<double>(c.y) - eye[1];
        const double z = static_cast<double>(c.z) - eye[2], near = static_cast<double>(near_m + piece.sphere.radius);
        const Visibility hidden = x * x + y * y + z * z < near * near ? Visibility::far : Visibility::near;
        for (const Span &span : piece.spans) {
            if (span.seen == hidden) continue;
            const size_t layer = static_cast<size_t>(span.layer);
            const auto first = layers_[layer].indices().begin() + span.first;
            choice[layer].insert(choice[layer].end(), first, first + span.count);
        }
    }
    size_t sum = 0;
    for (const std::vector<uint32_t> &indices : choice) sum += indices.size() / 3;
    return sum;
}

void Pieces::draw(const Gl &g, SurfaceKind layer, const Choice &choice) const
{
    const std::vector<uint32_t> &indices = choice[static_cast<size_t>(layer)];
    if (indices.empty()) return;
    constexpr int stride = sizeof(SceneryVertex);
    const SceneryVertex *v = on(layer).vertices().data();
    for (const unsigned array : {gl::vertex_array, gl::normal_array, gl::color_array, gl::texcoord_array})
        g.EnableClientState(array);
    g.VertexPointer(3, gl::float_type, stride, &v->position);
    g.NormalPointer(gl::float_type, stride, &v->normal);
    g.TexCoordPointer(2, gl::float_type, stride, &v->u);
    g.ColorPointer(4, gl::unsigned_byte, stride, v->rgba);
    g.DrawElements(gl::triangles, static_cast<int>(indices.size()), gl::unsigned_int, indices.data());
    for (const unsigned array : {gl::vertex_array, gl::normal_array, gl::color_array, gl::texcoord_array})
        g.DisableClientState(array);
}

}  // namespace scenes::town
