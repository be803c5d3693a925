#include "passes/batch.h"

#include <algorithm>
#include <cmath>

#include "lib/math/simd.h"

namespace claque::passes
{
namespace
{

// From the coordinates of an array to eye space, and from its normals to directions there. Rounded to floats, in one
// way for all formats.
struct EyeTransform {
    math::F4 position[4];  // columns x, y, z, offset; lane 3 unused
    math::F4 normal[3];    // columns

    explicit EyeTransform(const Individual &individual) : position(), normal()
    {
        const float *m = individual.item->model_view;
        const draw::Vertices &vertices = individual.vertices;
        double columns[3][3];
        for (int c = 0; c < 3; ++c)
            for (int r = 0; r < 3; ++r) columns[c][r] = static_cast<double>(m[4 * c + r]);
        for (int r = 0; r < 3; ++r) {
            double moved = static_cast<double>(m[12 + r]);
            for (int c = 0; c < 3; ++c) {
                const double step = vertices.packed() ? static_cast<double>(vertices.step) : 1.0;
                if (vertices.packed()) moved += columns[c][r] * static_cast<double>(vertices.offset[c]);
                position[c][r] = static_cast<float>(columns[c][r] * step);
            }
            position[3][r] = static_cast<float>(moved);
        }
        // Cofactors: the inverse transpose up to a factor, which GL_NORMALIZE removes. The factor's sign is that of the
        // mirroring.
        double sum = 0, cofactors[3][3];
        for (int c = 0; c < 3; ++c) {
            const double *a = columns[(c + 1) % 3], *b = columns[(c + 2) % 3];
            for (int r = 0; r < 3; ++r)
                cofactors[c][r] = a[(r + 1) % 3] * b[(r + 2) % 3] - a[(r + 2) % 3] * b[(r + 1) % 3];
            sum += cofactors[c][0] * cofactors[c][0] + cofactors[c][1] * cofactors[c][1] +
                   cofactors[c][2] * cofactors[c][2];
        }
        // Scales to about length 1, so that no scale exceeds the range of floats.
        double factor = sum > 0 ? 1 / std::sqrt(sum / 3) : 1;
        if (individual.item->mirrored) factor = -factor;
        for (int c = 0; c < 3; ++c)
            for (int r = 0; r < 3; ++r) normal[c][r] = static_cast<float>(cofactors[c][r] * factor);
    }
};

math::F4 turned(const math::F4 *columns, float x, float y, float z)
{
    return columns[0] * math::splat(x) + columns[1] * math::splat(y) + columns[2] * math::splat(z);
}

}  // namespace

bool Batch::fits(const model::Template &tmpl, const model::Level &level, uint32_t max_triangles)
{
    if (level.surfaces.size() != 1 || level.surfaces[0].dirty.count != 0) return false;
    const model::Surface &surface = level.surfaces[0];
    return surface.fused.count != 0 && surface.fused.count <= 3 * uint64_t(max_triangles) &&
           level.vertex_count <= Scratch::batch_vertices && surface.fused.count <= Scratch::batch_indices &&
           !tmpl.textures[surface.texture].has_holes && level.colours.empty() && part_count_of(level) == 1;
}

bool Batch::takes(const Individual &individual) const
{
    return !individual.item->hooks && !individual.item->locals && !individual.own && individual.ready->batched;
}

Batch::ArrayCounts Batch::counts_of(const Individual &individual)
{
    const FlatLevel &flat = individual.ready->flat;
    if (!flat.indices.empty())
        return {static_cast<uint32_t>(flat.vertices.size()), static_cast<uint32_t>(flat.indices.size())};
    return {individual.level->vertex_count, individual.level->surfaces[0].fused.count};
}

void Batch::add(const Individual &individual)
{
    SurfaceState wanted = Canvas::state_of(individual, individual.level->surfaces[0]);
    wanted.colour_array = true;
    wanted.flat = !individual.ready->flat.indices.empty();
    if (wanted.flat) wanted.texture = 0;
    const ArrayCounts counts = counts_of(individual);
    const bool fits =
        vertices_ + counts.vertices <= Scratch::batch_vertices && indices_ + counts.indices <= Scratch::batch_indices;
    if (vertices_ != 0 && (!(wanted == surface_) || !fits)) flush();
    surface_ = wanted;
    wanted.flat ? add_flat(individual) : add_vertices(individual);
    add_colours(individual);
    add_triangles(individual);
    vertices_ += counts.vertices;
    indices_ += counts.indices;
    ++stats_.individuals;
    ++stats_.parts;
    stats_.triangles += counts.indices / 3;
    stats_.vertices += counts.vertices;
}

void Batch::add_vertices(const Individual &individual)
{
    const EyeTransform transform(individual);
    const draw::Vertices &from = individual.vertices;
    float *positions = scratch_.batch.positions.data() + 3 * size_t(vertices_);
    float *normals = scratch_.batch.normals.data() + 3 * size_t(vertices_);
    // Each store of four floats overlaps the next vertex, which then overwrites it; the arrays have one more float.
    const auto move = [&](const auto *p, const auto *n, size_t stride) {
        for (uint32_t v = 0; v < individual.level->vertex_count; ++v, p += stride, n += stride) {
            const math::F4 position =
                turned(transform.position, float(p[0]), float(p[1]), float(p[2])) + transform.position[3];
            math::store4(positions + 3 * size_t(v), position);
            math::store4(normals + 3 * size_t(v), turned(transform.normal, float(n[0]), float(n[1]), float(n[2])));
        }
    };
    from.packed() ? move(from.short_positions, from.byte_normals, 4) : move(from.positions, from.normals, 3);
}

// Triangles are lit by their face normals. Triangles that share a provoking vertex are lit by the sum of their normals,
// weighted by area.
void Batch::add_flat(const Individual &individual)
{
    const FlatLevel &flat = individual.ready->flat;
    const EyeTransform transform(individual);
    const draw::Vertices &from = individual.vertices;
    float *positions = scratch_.batch.positions.data() + 3 * size_t(vertices_);
    float *normals = scratch_.batch.normals.data() + 3 * size_t(vertices_);
    const auto move = [&](const auto *p, size_t stride) {
        for (size_t v = 0; v < flat.vertices.size(); ++v) {
            const auto *at = p + stride * flat.vertices[v];
            math::store4(positions + 3 * v,
                         turned(transform.position, float(at[0]), float(at[1]), float(at[2])) + transform.position[3]);
        }
    };
    from.packed() ? move(from.short_positions, 4) : move(from.positions, 3);
    std::fill(normals, normals + 3 * flat.vertices.size(), 0.0f);
    const math::F4 outwards = math::splat(individual.item->mirrored ? -1.0f : 1.0f);
    for (const uint16_t *t = flat.indices.data(); t != flat.indices.data() + flat.indices.size(); t += 3) {
        const math::F4 a = math::load4(positions + 3 * t[0]);
        const math::F4 u = math::load4(positions + 3 * t[1]) - a, v = math::load4(positions + 3 * t[2]) - a;
        float *normal = normals + 3 * t[2];
        math::store3(normal, math::load4(normal) + outwards * math::yzx(u * math::yzx(v) - math::yzx(u) * v));
    }
}

void Batch::add_colours(const Individual &individual)
{
    const size_t first = vertices_;
    const bool flat = surface_.flat, ubyte = options_.colours == ColourFormat::ubyte;
    if (!flat)
        std::copy(individual.level->uvs.begin(), individual.level->uvs.end(),
                  scratch_.batch.uvs.begin() + std::ptrdiff_t(2 * first));
    const auto fill = [&](auto &table, auto *out) {
        flat ? flat_colours(individual, table, out) : slot_colours(individual, 0, table, out);
    };
    ubyte ? fill(scratch_.ubyte_table, scratch_.batch.ubyte.data() + first)
          : fill(scratch_.real_table, scratch_.batch.real.data() + first);
}

void Batch::add_triangles(const Individual &individual)
{
    uint16_t *out = scratch_.batch.indices.data() + indices_;
    const auto add = [&](const auto *from, uint32_t count) {
        for (uint32_t i = 0; i < count; ++i) out[i] = static_cast<uint16_t>(vertices_ + from[i]);
    };
    const model::IndexRange fused = individual.level->surfaces[0].fused;
    const Array<uint16_t> &flat = individual.ready->flat.indices;
    surface_.flat ? add(flat.data(), static_cast<uint32_t>(flat.size()))
                  : add(individual.level->indices.data() + fused.first, fused.count);
}

void Batch::flush()
{
    if (vertices_ == 0) return;
    static const float identity[16] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
    const BatchArrays &arrays = scratch_.batch;
    state_.apply(surface_);
    gl_.LoadMatrixf(identity);
    gl_.VertexPointer(3, gl::real, 0, arrays.positions.data());
    gl_.NormalPointer(gl::real, 0, arrays.normals.data());
    if (!surface_.flat) gl_.TexCoordPointer(2, gl::real, 0, arrays.uvs.data());
    if (options_.colours == ColourFormat::ubyte) gl_.ColorPointer(4, gl::unsigned_byte, 0, arrays.ubyte.data());
    else gl_.ColorPointer(4, gl::real, 0, arrays.real.data());
    gl_.DrawElements(gl::triangles, static_cast<int32_t>(indices_), gl::unsigned_short, arrays.indices.data());
    ++stats_.draws;
    vertices_ = indices_ = 0;
}

}  // namespace claque::passes
