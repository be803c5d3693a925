#include "passes/shadow_batch.h"

#include <algorithm>

namespace claque::passes
{
namespace
{

// Larger meshes cost more to copy than a call does.
constexpr uint32_t max_indices = 3 * 250;

}  // namespace

void ShadowArrays::reserve(uint32_t vertices)
{
    if (flat.size() < 3 * size_t(vertices)) flat.resize(3 * size_t(vertices));
    if (window.size() < vertices) window.resize(vertices);
    if (indices.empty()) indices.resize(batch_indices);
    if (positions.empty()) positions.resize(3 * size_t(batch_vertices));
}

void ShadowBatch::load_identity()
{
    static const float identity[16] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
    gl_.LoadMatrixf(identity);
}

void ShadowBatch::make_room(uint32_t vertices, uint32_t indices)
{
    if (vertices_ + vertices > ShadowArrays::batch_vertices || indices_ + indices > ShadowArrays::batch_indices)
        flush();
}

void ShadowBatch::add(const FlattenedMesh &flat)
{
    if (flat.vertices > ShadowArrays::batch_vertices || flat.count > max_indices) {
        flush();
        load_identity();
        gl_.VertexPointer(3, gl::real, 0, flat.positions);
        return draw(flat.indices, flat.count);
    }
    make_room(flat.vertices, flat.count);
    std::copy(flat.positions, flat.positions + 3 * size_t(flat.vertices),
              arrays_.positions.begin() + 3 * std::ptrdiff_t(vertices_));
    for (uint32_t i = 0; i < flat.count; ++i)
        arrays_.indices[indices_ + i] = static_cast<uint16_t>(vertices_ + flat.indices[i]);
    vertices_ += flat.vertices;
    indices_ += flat.count;
}

void ShadowBatch::add(const glm::vec3 (&corners)[4])
{
    make_room(4, 6);
    float *out = arrays_.positions.data() + 3 * size_t(vertices_);
    for (const glm::vec3 &corner : corners)
        for (int k = 0; k < 3; ++k) *out++ = corner[k];
    for (const uint32_t k : {0u, 1u, 2u, 0u, 2u, 3u})
        arrays_.indices[indices_++] = static_cast<uint16_t>(vertices_ + k);
    vertices_ += 4;
}

void ShadowBatch::draw(const uint32_t *indices, uint32_t count)
{
    gl_.DrawElements(gl::triangles, static_cast<int32_t>(count), gl::unsigned_int, indices);
    ++stats_.draws;
    stats_.triangles += count / 3;
}

void ShadowBatch::flush()
{
    if (indices_ == 0) return;
    load_identity();
    gl_.VertexPointer(3, gl::real, 0, arrays_.positions.data());
    gl_.DrawElements(gl::triangles, static_cast<int32_t>(indices_), gl::unsigned_short, arrays_.indices.data());
    ++stats_.draws;
    stats_.triangles += indices_ / 3;
    vertices_ = indices_ = 0;
}

}  // namespace claque::passes
