#include "passes/canvas.h"

#include "passes/colour_product.h"

namespace claque::passes
{
namespace
{

// Converts as Mesa does for 8-bit colour arrays. Mesa's glColor4ub divides instead and differs by one ulp, which after
// lighting and rounding sometimes changes a pixel. So a current colour is given as floats whatever the format of the
// arrays.
constexpr float real_of(uint8_t value) { return static_cast<float>(value) * (1.0f / 255.0f); }

const uint8_t *rgb_of(const Individual &individual, const ZoneTest &test)
{
    return individual.zone_rgb + 3 * test.zone;
}

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
void fill_table(const Individual &individual, const PreparedTexture &texture, Array<typename Format::Colour> &table)
{
    for (size_t zone = 0; zone < texture.tests.size(); ++zone) {
        const ZoneTest &test = texture.tests[zone];
        table[2 * zone] = Format::make(rgb_of(individual, test), 255, 1.0f);
        table[2 * zone + 1] = Format::make(rgb_of(individual, test), test.threshold_ubyte, test.threshold_real);
    }
}

template <class Format>
void tint(const model::Level &level, VertexRange range, typename Format::Colour *colours)
{
    if (level.colours.empty()) return;
    for (uint32_t v = range.first; v < range.end; ++v) Format::tint(colours[v], &level.colours[4 * v]);
}

// model_view * translation(offset) * scale(step): from the numbers of a packed position to eye space. Normals keep
// their direction under it; GL_NORMALIZE restores their length.
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

// Calls fill(reach) for each drawn part; not called if all parts are drawn.
template <class Fill>
void for_parts(const Individual &individual, uint32_t surface_index, Fill fill)
{
    const uint32_t count = part_count_of(*individual.level);
    const PartVertexRanges *reach = individual.ready->part_vertex_ranges.data() + size_t(surface_index) * count;
    for (uint32_t part = 0; part < count; ++part)
        if (individual.parts >> part & 1) fill(reach[part]);
}

template <class Format>
void fill_by_slot(const Individual &individual, uint32_t surface_index, Array<typename Format::Colour> &table,
                  Array<typename Format::Colour> &colours)
{
    fill_table<Format>(individual, individual.prepared->textures[individual.level->surfaces[surface_index].texture],
                       table);
    const uint16_t *slots = individual.level->slots.data();
    const auto fill = [&](VertexRange range) {
        for (uint32_t v = range.first; v < range.end; ++v) colours[v] = table[slots[v]];
        tint<Format>(*individual.level, range, colours.data());
    };
    if (individual.whole()) return fill(individual.ready->fused_vertices[surface_index]);
    for_parts(individual, surface_index, [&](const PartVertexRanges &reach) {
        fill(reach.sources);
        fill(reach.copies);
    });
}

template <class Format>
void fill_with_zone(const Individual &individual, uint32_t surface_index, const ZoneTest &test,
                    Array<typename Format::Colour> &colours)
{
    const typename Format::Colour colour = Format::make(rgb_of(individual, test), 255, 1.0f);
    const auto fill = [&](VertexRange range) {
        for (uint32_t v = range.first; v < range.end; ++v) colours[v] = colour;
        tint<Format>(*individual.level, range, colours.data());
    };
    if (individual.whole()) return fill({0, individual.level->source_count});
    for_parts(individual, surface_index, [&](const PartVertexRanges &reach) { fill(reach.sources); });
}

template <class Format>
void colours_of_slots(const Individual &individual, uint32_t surface_index, Array<typename Format::Colour> &table,
                      typename Format::Colour *out)
{
    fill_table<Format>(individual, individual.prepared->textures[individual.level->surfaces[surface_index].texture],
                       table);
    const uint16_t *slots = individual.level->slots.data();
    for (uint32_t v = 0; v < individual.level->vertex_count; ++v) out[v] = table[slots[v]];
}

template <class Format>
void colours_of_entries(const Individual &individual, Array<typename Format::Colour> &table,
                        typename Format::Colour *out)
{
    const FlatLevel &flat = individual.ready->flat;
    for (uint32_t colour_entry = 0; colour_entry < flat.zones.size(); ++colour_entry) {
        table[colour_entry] = Format::make(individual.zone_rgb + 3 * size_t(flat.zones[colour_entry]), 255, 1.0f);
        Format::tint(table[colour_entry], flat.texel(colour_entry, individual.item->texture_set));
    }
    for (size_t v = 0; v < flat.colour_entries.size(); ++v) out[v] = table[flat.colour_entries[v]];
}

}  // namespace

void flat_colours(const Individual &individual, Array<Ubyte4> &table, Ubyte4 *out)
{
    colours_of_entries<UbyteColours>(individual, table, out);
}

void flat_colours(const Individual &individual, Array<Real4> &table, Real4 *out)
{
    colours_of_entries<RealColours>(individual, table, out);
}

void slot_colours(const Individual &individual, uint32_t surface_index, Array<Ubyte4> &table, Ubyte4 *out)
{
    colours_of_slots<UbyteColours>(individual, surface_index, table, out);
}

void slot_colours(const Individual &individual, uint32_t surface_index, Array<Real4> &table, Real4 *out)
{
    colours_of_slots<RealColours>(individual, surface_index, table, out);
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
    batch.positions.resize(3 * size_t(batch_vertices) + 1);  // last, as its size shows that all are reserved
}

void Canvas::bind_vertices(const Individual &individual)
{
    const draw::Vertices &vertices = individual.vertices;
    if (vertices.packed()) {
        float unpacking[16];
        unpacking_matrix(individual.item->model_view, vertices, unpacking);
        gl_.LoadMatrixf(unpacking);
        gl_.VertexPointer(3, gl::signed_short, 4 * sizeof(int16_t), vertices.short_positions);
        gl_.NormalPointer(gl::signed_byte, 4, vertices.byte_normals);
    } else {
        gl_.LoadMatrixf(individual.item->model_view);
        gl_.VertexPointer(3, gl::real, 0, vertices.positions);
        gl_.NormalPointer(gl::real, 0, vertices.normals);
    }
    gl_.TexCoordPointer(2, gl::real, 0, individual.level->uvs.data());
    ++stats_.individuals;
    stats_.parts += count_of(individual.parts);
    const bool copies = individual.prepared->strategy == Strategy::fused && !individual.close && !individual.one_colour;
    stats_.vertices += copies ? individual.level->vertex_count : individual.level->source_count;
    stats_.close_individuals += individual.close != nullptr;
}

SurfaceState Canvas::state_of(const Individual &individual, const model::Surface &surface)
{
    SurfaceState state;
    const size_t index = static_cast<size_t>(&surface - individual.level->surfaces.data());
    const bool linear = !individual.ready->linear.empty() && individual.ready->linear[index];
    const uint32_t step = individual.ready->smooth.empty() ? 0 : individual.ready->smooth[index];
    const PreparedTexture &texture = individual.prepared->textures[surface.texture];
    state.texture = individual.own ? *individual.own : texture.name_of(individual.item->texture_set, linear, step);
    state.double_sided = surface.double_sided;
    state.lighting = surface.lighting;
    state.mirrored = individual.item->mirrored;
    state.colour_array = !individual.level->colours.empty();
    return state;
}

void Canvas::use_zone_colour(const Individual &individual, uint32_t surface_index, const ZoneTest &test)
{
    const uint8_t *rgb = rgb_of(individual, test);
    const bool ubyte = options_.colours == ColourFormat::ubyte;
    if (!individual.level->colours.empty()) {
        ubyte ? fill_with_zone<UbyteColours>(individual, surface_index, test, scratch_.ubyte)
              : fill_with_zone<RealColours>(individual, surface_index, test, scratch_.real);
        ubyte ? gl_.ColorPointer(4, gl::unsigned_byte, 0, scratch_.ubyte.data())
              : gl_.ColorPointer(4, gl::real, 0, scratch_.real.data());
    } else {
        gl_.Color4f(real_of(rgb[0]), real_of(rgb[1]), real_of(rgb[2]), 1.0f);
    }
}

void Canvas::use_slot_colours(const Individual &individual, uint32_t surface_index)
{
    if (options_.colours == ColourFormat::ubyte) {
        fill_by_slot<UbyteColours>(individual, surface_index, scratch_.ubyte_table, scratch_.ubyte);
        gl_.ColorPointer(4, gl::unsigned_byte, 0, scratch_.ubyte.data());
    } else {
        fill_by_slot<RealColours>(individual, surface_index, scratch_.real_table, scratch_.real);
        gl_.ColorPointer(4, gl::real, 0, scratch_.real.data());
    }
}

void Canvas::use_own_colours(const Individual &individual)
{
    constexpr uint8_t white[3] = {255, 255, 255};
    Individual plain = individual;
    plain.zone_rgb = white;
    plain.parts = every_part_of(*individual.level);
    use_zone_colour(plain, 0, ZoneTest());
}

void Canvas::triangles(const Individual &individual, const IndexSlice &slice)
{
    send(individual, slice, {individual.ready->short_indices, individual.level->indices});
}

void Canvas::plain_triangles(const Individual &individual, uint32_t surface_index)
{
    const PlainLevel &plain = individual.ready->plain;
    const uint32_t *firsts = plain.firsts.data() + size_t(surface_index) * (part_count_of(*individual.level) + 1);
    send(individual, {plain.ranges[surface_index], firsts}, {plain.short_indices, plain.indices});
}

void Canvas::send(const Individual &individual, const IndexSlice &slice, const Indices &indices)
{
    if (!individual.whole())
        for_runs(slice, individual.parts, part_count_of(*individual.level),
                 [&](model::IndexRange run) { draw_elements(indices, run); });
    else if (slice.range.count != 0) draw_elements(indices, slice.range);
}

void Canvas::draw_elements(const Indices &indices, model::IndexRange range)
{
    const int32_t count = static_cast<int32_t>(range.count);
    if (indices.shorts.empty())
        gl_.DrawElements(gl::triangles, count, gl::unsigned_int, indices.ints.data() + range.first);
    else gl_.DrawElements(gl::triangles, count, gl::unsigned_short, indices.shorts.data() + range.first);
    ++stats_.draws;
    stats_.triangles += range.count / 3;
}

}  // namespace claque::passes
