#include "passes/visibility_drawer.h"

#include <algorithm>

#include "passes/gl_state.h"
#include "passes/list_drawer.h"
#include "passes/parts.h"

namespace claque::passes
{
namespace
{

constexpr gl::Enum fog = 0x0B60, dither = 0x0BD0;

}  // namespace

void VisibilityArrays::reserve()
{
    positions.resize(3 * max_corners);
    uvs.resize(2 * max_corners);
    colours.resize(4 * max_corners);
    if (indices.size() == max_corners) return;
    indices.resize(max_corners);
    for (uint32_t i = 0; i < max_corners; ++i) indices[i] = static_cast<uint16_t>(i);
}

void VisibilityDrawer::begin(Multisample multisample)
{
    GlState(gl_, stats_).begin(list_.projection, multisample);
    for (const gl::Enum off : {gl::lighting, fog, dither, gl::polygon_offset_fill, gl::colour_material})
        gl_.Disable(off);
    gl_.ColorMask(gl::yes, gl::yes, gl::yes, gl::no);
    gl_.ShadeModel(gl::flat);
    // The colour of the vertices and the alpha of the texture, which has alpha alone.
    gl_.TexEnvi(gl::texture_env, gl::texture_env_mode, static_cast<int32_t>(gl::replace));
    gl_.AlphaFunc(gl::gequal, 0.5f);
    gl_.DisableClientState(gl::normal_array);
    gl_.EnableClientState(gl::colour_array);
    gl_.VertexPointer(3, gl::real, 0, arrays_.positions.data());
    gl_.TexCoordPointer(2, gl::real, 0, arrays_.uvs.data());
    gl_.ColorPointer(4, gl::unsigned_byte, 0, arrays_.colours.data());
}

base::Status VisibilityDrawer::draw(Multisample multisample)
{
    begin(multisample);
    base::Status first;
    uint64_t number = options_.first_number;
    for (size_t i = 0; i < list_.items.size(); ++i) {
        const draw::Item &item = list_.items[i];
        const uint64_t own = number;
        number += draw::triangle_count(item.tmpl->levels[item.level]);
        if (!shows(item) || (options_.drawn && options_.drawn[i] == 0)) continue;
        const draw::Vertices vertices = item.vertices.any() ? item.vertices : options_.placed_by_gl->vertices_of(item);
        if (vertices.any()) draw_item(item, vertices, own);
        else if (first.ok())
            first = base::Status::bad(CLQ_OUT_OF_MEMORY, "actor %u: no memory for its vertices", item.actor_index + 1);
    }
    return first;
}

void VisibilityDrawer::draw_item(const draw::Item &item, const draw::Vertices &vertices, uint64_t first)
{
    const model::Level &level = item.tmpl->levels[item.level];
    gl_.LoadMatrixf(item.model_view);
    gl_.FrontFace(item.mirrored ? gl::cw : gl::ccw);
    const model::Surface *shown = nullptr;
    uint64_t number = first;
    draw::for_bins(level,
                   [&](const model::Surface &surface, const model::IndexRange &range, uint32_t, const uint32_t *parts) {
                       if (shown != &surface) flush(), set_surface(item, surface);
                       shown = &surface;
                       for_runs({range, parts}, item.parts, part_count_of(level), [&](const model::IndexRange &run) {
                           for (uint32_t i = 0; i < run.count; i += 3)
                               add(level, vertices, run.first + i, number + (run.first + i - range.first) / 3);
                       });
                       number += range.count / 3;
                   });
    flush();
    ++stats_.individuals;
    stats_.parts += count_of(item.parts & every_part_of(level));
}

void VisibilityDrawer::set_surface(const draw::Item &item, const model::Surface &surface)
{
    surface.double_sided ? gl_.Disable(gl::cull_face) : gl_.Enable(gl::cull_face);
    const uint32_t holes = holes_.find(*item.tmpl, surface.texture, item.texture_set);
    has_holes_ = holes != 0;
    const auto set = [&](gl::Enum what) { has_holes_ ? gl_.Enable(what) : gl_.Disable(what); };
    set(gl::alpha_test);
    set(gl::texture_2d);
    has_holes_ ? gl_.EnableClientState(gl::texture_coord_array) : gl_.DisableClientState(gl::texture_coord_array);
    if (has_holes_) gl_.BindTexture(gl::texture_2d, holes);
}

void VisibilityDrawer::add(const model::Level &level, const draw::Vertices &vertices, uint32_t first_index,
                           uint64_t number)
{
    if (corners_ == VisibilityArrays::max_corners) flush();
    const uint64_t bits = options_.upper_bits ? number >> 24 : number;
    const uint8_t rgba[4] = {static_cast<uint8_t>(bits), static_cast<uint8_t>(bits >> 8),
                             static_cast<uint8_t>(bits >> 16), 255};
    for (uint32_t k = 0; k < 3; ++k, ++corners_) {
        const uint32_t vertex = level.indices[first_index + k];
        const glm::vec3 position = vertices.position(vertex);
        std::copy_n(&position.x, 3, &arrays_.positions[3 * size_t(corners_)]);
        std::copy(rgba, rgba + 4, &arrays_.colours[4 * size_t(corners_)]);
        if (has_holes_) std::copy_n(&level.uvs[2 * size_t(vertex)], 2, &arrays_.uvs[2 * size_t(corners_)]);
    }
}

void VisibilityDrawer::flush()
{
    if (corners_ == 0) return;
    gl_.DrawElements(gl::triangles, static_cast<int32_t>(corners_), gl::unsigned_short, arrays_.indices.data());
    ++stats_.draws;
    stats_.triangles += corners_ / 3;
    stats_.vertices += corners_;
    corners_ = 0;
}

}  // namespace claque::passes
