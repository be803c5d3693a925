#include "passes/shadow_drawer.h"

#include <algorithm>

#include "passes/guard.h"
#include "passes/shadow_blob.h"

namespace claque::passes
{
namespace
{

constexpr uint32_t blob_samples = 32;  // vertices that determine an ellipse

template <class Do>
void for_vertices(const draw::Vertices &vertices, uint32_t count, uint32_t step, Do act)
{
    if (vertices.packed())
        for (uint32_t v = 0; v < count; v += step) {
            const int16_t *p = vertices.short_positions + 4 * size_t(v);
            act(static_cast<float>(p[0]), static_cast<float>(p[1]), static_cast<float>(p[2]));
        }
    else
        for (uint32_t v = 0; v < count; v += step) {
            const float *p = vertices.positions + 3 * size_t(v);
            act(p[0], p[1], p[2]);
        }
}

}  // namespace

bool casts(const draw::Item &item)
{
    const model::Level &level = item.tmpl->levels[item.level];
    return level.source_count > 0 && !level.indices.empty();
}

ShadowDrawer::ShadowDrawer(const Gl11 &gl, const Preflight &preflight, const Array<PreparedTemplate> &templates,
                           Scratch &scratch, const draw::DrawList &list, const ShadowOptions &options,
                           ShadowTarget target, ShadowStats &stats)
    : gl_(gl),
      preflight_(preflight),
      templates_(templates),
      scratch_(scratch),
      list_(list),
      options_(options),
      target_(target),
      stats_(stats),
      plane_finder_(options, list),
      batch_(gl, scratch.shadow, stats)
{
}

void ShadowDrawer::set_state()
{
    DrawStats unused;
    GlState(gl_, unused).begin(list_.projection, preflight_.multisample(false));
    for (const gl::Enum off : {gl::texture_2d, gl::lighting, gl::alpha_test, gl::cull_face}) gl_.Disable(off);
    gl_.DisableClientState(gl::normal_array);
    gl_.DisableClientState(gl::texture_coord_array);
    gl_.DisableClientState(gl::colour_array);
    gl_.DepthMask(gl::no);
    gl_.Enable(gl::blend);
    gl_.BlendFunc(gl::src_alpha, gl::one_minus_src_alpha);
    gl_.Enable(gl::polygon_offset_fill);
    gl_.PolygonOffset(-1, -1);
    gl_.Color4f(options_.rgb[0], options_.rgb[1], options_.rgb[2], options_.darkness);
}

void ShadowDrawer::set_stencil()
{
    const uint32_t bit = uint32_t(1) << options_.stencil_bit;
    gl_.StencilMask(bit);
    gl_.ClearStencil(0);
    gl_.Clear(gl::stencil_buffer_bit);
    gl_.Enable(gl::stencil_test);
    gl_.StencilFunc(gl::notequal, static_cast<int32_t>(bit), bit);
    gl_.StencilOp(gl::keep, gl::keep, gl::replace);
}

base::Status ShadowDrawer::draw()
{
    const StateGuard guard(gl_, Guard::full, preflight_.multisample(false), gl::stencil_buffer_bit);
    set_state();
    if (options_.stencil_bit >= 0) set_stencil();
    else shadow_mask_.emplace(list_.projection, target_.width, target_.height, scratch_.shadow, batch_);
    base::Status first;
    const PreparedTemplate *prepared = nullptr;
    for (const draw::Item &item : list_.items) {
        if (!casts(item) || item.eye_distance_m >= options_.none_from_m) continue;
        if (!prepared || prepared->source != item.tmpl) prepared = find(templates_, item.tmpl);
        if (!cast(item, prepared->levels[item.level]) && first.ok())
            first = base::Status::bad(CLQ_OUT_OF_MEMORY, "actor %u: no memory for its vertices at the update",
                                      item.actor_index + 1);
    }
    batch_.flush();
    return first.ok() ? plane_finder_.status() : first;
}

// False if the item has no vertices.
bool ShadowDrawer::cast(const draw::Item &item, const PreparedLevel &ready)
{
    ShadowPlane plane;
    if (!plane_finder_.find(item, plane)) return true;
    const draw::Vertices &vertices = item.vertices;
    if (!item.locals && !vertices.any()) return false;
    ++stats_.individuals;
    stats_.shadow_only += item.shadow_only;
    const bool blob = item.eye_distance_m >= options_.blob_from_m;
    const uint32_t count = item.tmpl->levels[item.level].source_count;
    flat_count_ = count;
    if (item.locals) flatten_parts(plane, item, ready);
    else {
        const Flattener flattener(plane, item.model_view, vertices);
        if (!blob && !shadow_mask_ && plane.parallel && !ready.batched) {
            draw_by_matrix(flattener, vertices, ready);
            return true;
        }
        flatten(flattener, vertices, blob ? std::max(1u, count / blob_samples) : 1);
    }
    blob ? cast_blob(plane, ready, item.locals != nullptr) : cast_mesh(plane, ready);
    return true;
}

void ShadowDrawer::flatten(const Flattener &flattener, const draw::Vertices &vertices, uint32_t step)
{
    float *out = scratch_.shadow.flat.data();
    const uint32_t count = flat_count_;
    for_vertices(vertices, count, step, [&](float x, float y, float z) {
        flattener(x, y, z, out);
        out += 3;
    });
    flat_count_ = static_cast<uint32_t>(out - scratch_.shadow.flat.data()) / 3;
    stats_.vertices += flat_count_;
}

// As MatrixWalk, but matrices are multiplied here: projecting with GL's stack would leave the parts standing.
void ShadowDrawer::flatten_parts(const ShadowPlane &plane, const draw::Item &item, const PreparedLevel &ready)
{
    float *flat = scratch_.shadow.flat.data();
    for (const MatrixStep &step : ready.steps) {
        math::Affine &placed = scratch_.chain[step.depth - 1];
        const math::Affine &local = item.locals[step.node];
        placed = step.depth == 1 ? local : math::mul(scratch_.chain[step.depth - 2], local);
        const Flattener flattener(plane, item.model_view, placed);
        for (uint32_t part = 0; part + 1 < ready.shadow_firsts.size(); ++part) {
            if (!(step.own >> part & 1)) continue;
            for (uint32_t i = ready.shadow_firsts[part]; i < ready.shadow_firsts[part + 1]; ++i) {
                const size_t v = 3 * size_t(ready.shadow_indices[i]);
                const float *p = ready.positions.data() + v;
                flattener(p[0], p[1], p[2], flat + v);
            }
        }
    }
    stats_.vertices += flat_count_;
}

// `by_indices`: only the vertices of triangles have been flattened.
void ShadowDrawer::cast_blob(const ShadowPlane &plane, const PreparedLevel &ready, bool by_indices)
{
    ++stats_.blobs;
    PlanarMoments moments(plane);
    const float *flat = scratch_.shadow.flat.data();
    const uint32_t count = by_indices ? static_cast<uint32_t>(ready.shadow_indices.size()) : flat_count_;
    const uint32_t step = std::max(1u, count / blob_samples);
    for (uint32_t v = 0; v < count; v += step) moments.add(flat + 3 * size_t(by_indices ? ready.shadow_indices[v] : v));
    float corners[3 * blob_corners];
    moments.ellipse(corners);
    add(plane, {corners, blob_corners, blob_indices, blob_indices_count});
}

void ShadowDrawer::cast_mesh(const ShadowPlane &plane, const PreparedLevel &ready)
{
    add(plane, {scratch_.shadow.flat.data(), flat_count_, ready.shadow_indices.data(),
                static_cast<uint32_t>(ready.shadow_indices.size())});
}

void ShadowDrawer::add(const ShadowPlane &plane, const FlattenedMesh &flat)
{
    shadow_mask_ ? shadow_mask_->add(plane, flat) : batch_.add(flat);
}

// GL reads the cached vertices itself.
void ShadowDrawer::draw_by_matrix(const Flattener &flattener, const draw::Vertices &vertices,
                                  const PreparedLevel &ready)
{
    batch_.flush();
    float matrix[16];
    flattener.store(matrix);
    gl_.LoadMatrixf(matrix);
    if (vertices.packed()) gl_.VertexPointer(3, gl::signed_short, 4 * sizeof(int16_t), vertices.short_positions);
    else gl_.VertexPointer(3, gl::real, 0, vertices.positions);
    batch_.draw(ready.shadow_indices.data(), static_cast<uint32_t>(ready.shadow_indices.size()));
    stats_.vertices += flat_count_;
}

}  // namespace claque::passes
