#include "passes/canvas.h"

namespace claque::passes
{
namespace
{

// One rounding for all strategies and both formats, or their pictures would differ by a bit.
constexpr uint8_t product(uint8_t a, uint8_t b) { return static_cast<uint8_t>((2 * a * b + 255) / 510); }
// As Mesa reads 8-bit colour arrays. Its glColor4ub divides instead, an ulp apart, which lighting and rounding turn
// into other pixels now and then: so a current colour is given as floats, whatever the arrays are.
constexpr float real_of(uint8_t value) { return static_cast<float>(value) * (1.0f / 255.0f); }

const uint8_t *rgb_of(const Individual &who, const ZoneTest &test) { return who.zone_rgb + 3 * test.zone; }

struct UbyteColours {
    using Colour = Ubyte4;
    static Colour make(const uint8_t *rgb, uint8_t alpha, float) { return {rgb[0], rgb[1], rgb[2], alpha}; }
    static void tint(Colour &colour, const uint8_t *by)
    {
        for (int c = 0; c < 3; ++c) colour[c] = product(colour[c], by[c]);
    }
};

struct RealColours {
    using Colour = Real4;
    static Colour make(const uint8_t *rgb, uint8_t, float alpha)
    {
        return {real_of(rgb[0]), real_of(rgb[1]), real_of(rgb[2]), alpha};
    }
    static void tint(Colour &colour, const uint8_t *by)
    {
        for (int c = 0; c < 3; ++c)
            colour[c] = real_of(product(static_cast<uint8_t>(colour[c] * 255.0f + 0.5f), by[c]));
    }
};

template <class Format>
void fill_table(const Individual &who, const PreparedTexture &texture, Array<typename Format::Colour> &table)
{
    for (size_t zone = 0; zone < texture.tests.size(); ++zone) {
        const ZoneTest &test = texture.tests[zone];
        table[2 * zone] = Format::make(rgb_of(who, test), 255, 1.0f);
        table[2 * zone + 1] = Format::make(rgb_of(who, test), test.threshold_ubyte, test.threshold_real);
    }
}

template <class Format>
void tint(const model::Level &level, VertexRange range, typename Format::Colour *colours)
{
    if (level.colours.empty()) return;
    for (uint32_t v = range.first; v < range.end; ++v) Format::tint(colours[v], &level.colours[4 * v]);
}

// model_view * translation(offset) * scale(step): from numbers of a packed position to eye space. Normals keep their
// direction under it, and GL_NORMALIZE their length.
void unpacking_matrix(const float *model_view, const draw::Vertices &vertices, float *out)
{
    for (int row = 0; row < 4; ++row) {
        double moved = static_cast<double>(model_view[12 + row]);
        for (int column = 0; column < 3; ++column) {
            const double m = static_cast<double>(model_view[4 * column + row]);
            moved += m * static_cast<double>(vertices.offset[column]);
            out[4 * column + row] = static_cast<float>(m * static_cast<double>(vertices.step));
        }
        out[12 + row] = static_cast<float>(moved);
    }
}

// Calls fill(reach) for each part that is drawn, where not all are.
template <class Fill>
void for_parts(const Individual &who, uint32_t surface_index, Fill fill)
{
    const uint32_t count = part_count_of(*who.level);
    const PartReach *reach = who.ready->part_reach.data() + size_t(surface_index) * count;
    for (uint32_t part = 0; part < count; ++part)
        if (who.parts >> part & 1) fill(reach[part]);
}

template <class Format>
void fill_by_slot(const Individual &who, uint32_t surface_index, Array<typename Format::Colour> &table,
                  Array<typename Format::Colour> &colours)
{
    fill_table<Format>(who, who.prepared->textures[who.level->surfaces[surface_index].texture], table);
    const uint16_t *slots = who.level->slots.data();
    const auto fill = [&](VertexRange range) {
        for (uint32_t v = range.first; v < range.end; ++v) colours[v] = table[slots[v]];
        tint<Format>(*who.level, range, colours.data());
    };
    if (who.whole()) return fill(who.ready->fused_vertices[surface_index]);
    for_parts(who, surface_index, [&](const PartReach &reach) {
        fill(reach.sources);
        fill(reach.copies);
    });
}

template <class Format>
void fill_with_zone(const Individual &who, uint32_t surface_index, const ZoneTest &test,
                    Array<typename Format::Colour> &colours)
{
    const typename Format::Colour colour = Format::make(rgb_of(who, test), 255, 1.0f);
    const auto fill = [&](VertexRange range) {
        for (uint32_t v = range.first; v < range.end; ++v) colours[v] = colour;
        tint<Format>(*who.level, range, colours.data());
    };
    if (who.whole()) return fill({0, who.level->source_count});
    for_parts(who, surface_index, [&](const PartReach &reach) { fill(reach.sources); });
}

template <class Format>
void colours_of_slots(const Individual &who, uint32_t surface_index, Array<typename Format::Colour> &table,
                      typename Format::Colour *out)
{
    fill_table<Format>(who, who.prepared->textures[who.level->surfaces[surface_index].texture], table);
    const uint16_t *slots = who.level->slots.data();
    for (uint32_t v = 0; v < who.level->vertex_count; ++v) out[v] = table[slots[v]];
}

template <class Format>
void colours_of_looks(const Individual &who, Array<typename Format::Colour> &table, typename Format::Colour *out)
{
    const FlatLevel &flat = who.ready->flat;
    for (uint32_t look = 0; look < flat.zones.size(); ++look) {
        table[look] = Format::make(who.zone_rgb + 3 * size_t(flat.zones[look]), 255, 1.0f);
        Format::tint(table[look], flat.texel(look, who.item->texture_set));
    }
    for (size_t v = 0; v < flat.looks.size(); ++v) out[v] = table[flat.looks[v]];
}

}  // namespace

void flat_colours(const Individual &who, Array<Ubyte4> &table, Ubyte4 *out)
{
    colours_of_looks<UbyteColours>(who, table, out);
}

void flat_colours(const Individual &who, Array<Real4> &table, Real4 *out)
{
    colours_of_looks<RealColours>(who, table, out);
}

void slot_colours(const Individual &who, uint32_t surface_index, Array<Ubyte4> &table, Ubyte4 *out)
{
    colours_of_slots<UbyteColours>(who, surface_index, table, out);
}

void slot_colours(const Individual &who, uint32_t surface_index, Array<Real4> &table, Real4 *out)
{
    colours_of_slots<RealColours>(who, surface_index, table, out);
}

void Scratch::reserve(ColourFormat format, uint32_t vertices, uint32_t slots)
{
    const auto grow = [](auto &array, uint32_t count) {
        if (array.size() < count) array.resize(count);
    };
    if (format == ColourFormat::ubyte) {
        grow(ubyte, vertices);
        grow(ubyte_table, slots);
    } else {
        grow(real, vertices);
        grow(real_table, slots);
    }
}

void Scratch::reserve_chain(uint32_t depth)
{
    if (chain.size() < depth) chain.resize(depth);
}

void Scratch::reserve_batch(ColourFormat format)
{
    if (!batch.positions.empty()) return;
    batch.normals.resize(3 * size_t(batch_vertices) + 1);  // stored four at a time
    batch.uvs.resize(2 * size_t(batch_vertices));
    if (format == ColourFormat::ubyte) batch.ubyte.resize(batch_vertices);
    else batch.real.resize(batch_vertices);
    batch.indices.resize(batch_indices);
    batch.positions.resize(3 * size_t(batch_vertices) + 1);  // last: it says that all are there
}

void Canvas::place(const Individual &who)
{
    const draw::Vertices &vertices = who.vertices;
    if (vertices.packed()) {
        float unpacking[16];
        unpacking_matrix(who.item->model_view, vertices, unpacking);
        gl_.LoadMatrixf(unpacking);
        gl_.VertexPointer(3, gl::signed_short, 4 * sizeof(int16_t), vertices.short_positions);
        gl_.NormalPointer(gl::signed_byte, 4, vertices.byte_normals);
    } else {
        gl_.LoadMatrixf(who.item->model_view);
        gl_.VertexPointer(3, gl::real, 0, vertices.positions);
        gl_.NormalPointer(gl::real, 0, vertices.normals);
    }
    gl_.TexCoordPointer(2, gl::real, 0, who.level->uvs.data());
    ++stats_.individuals;
    stats_.parts += count_of(who.parts);
    stats_.vertices += who.prepared->strategy == Strategy::fused ? who.level->vertex_count : who.level->source_count;
}

SurfaceState Canvas::state_of(const Individual &who, const model::Surface &surface)
{
    SurfaceState state;
    const std::ptrdiff_t index = &surface - who.level->surfaces.data();
    const bool linear = !who.ready->linear.empty() && who.ready->linear[static_cast<size_t>(index)];
    state.texture = who.own ? *who.own : who.prepared->textures[surface.texture].name_of(who.item->texture_set, linear);
    state.double_sided = surface.double_sided;
    state.mirrored = who.item->mirrored;
    state.colour_array = !who.level->colours.empty();
    return state;
}

void Canvas::use_zone_colour(const Individual &who, uint32_t surface_index, const ZoneTest &test)
{
    const uint8_t *rgb = rgb_of(who, test);
    const bool ubyte = options_.colours == ColourFormat::ubyte;
    if (!who.level->colours.empty()) {
        ubyte ? fill_with_zone<UbyteColours>(who, surface_index, test, scratch_.ubyte)
              : fill_with_zone<RealColours>(who, surface_index, test, scratch_.real);
        ubyte ? gl_.ColorPointer(4, gl::unsigned_byte, 0, scratch_.ubyte.data())
              : gl_.ColorPointer(4, gl::real, 0, scratch_.real.data());
    } else {
        gl_.Color4f(real_of(rgb[0]), real_of(rgb[1]), real_of(rgb[2]), 1.0f);
    }
}

void Canvas::use_slot_colours(const Individual &who, uint32_t surface_index)
{
    if (options_.colours == ColourFormat::ubyte) {
        fill_by_slot<UbyteColours>(who, surface_index, scratch_.ubyte_table, scratch_.ubyte);
        gl_.ColorPointer(4, gl::unsigned_byte, 0, scratch_.ubyte.data());
    } else {
        fill_by_slot<RealColours>(who, surface_index, scratch_.real_table, scratch_.real);
        gl_.ColorPointer(4, gl::real, 0, scratch_.real.data());
    }
}

void Canvas::triangles(const Individual &who, const Stretch &stretch)
{
    if (!who.whole())
        for_runs(stretch, who.parts, part_count_of(*who.level),
                 [&](model::IndexRange run) { draw_elements(who, run); });
    else if (stretch.range.count != 0) draw_elements(who, stretch.range);
}

void Canvas::draw_elements(const Individual &who, model::IndexRange range)
{
    const int32_t count = static_cast<int32_t>(range.count);
    if (who.ready->short_indices.empty())
        gl_.DrawElements(gl::triangles, count, gl::unsigned_int, who.level->indices.data() + range.first);
    else gl_.DrawElements(gl::triangles, count, gl::unsigned_short, who.ready->short_indices.data() + range.first);
    ++stats_.draws;
    stats_.triangles += range.count / 3;
}

}  // namespace claque::passes
