// The drawing operations that the three strategies share: one individual at a time, its colours and its triangle
// ranges. Drawing allocates nothing; memory for colours is reserved when a template is prepared.
#pragma once

#include <array>

#include "lib/draw/draw_list.h"
#include "passes/gl_state.h"
#include "passes/parts.h"
#include "passes/prepared.h"
#include "passes/shadow_batch.h"

namespace claque::passes
{

using Ubyte4 = std::array<uint8_t, 4>;
using Real4 = std::array<float, 4>;

// Arrays of several individuals, one after the other: see Batch.
struct BatchArrays {
    explicit BatchArrays(std::pmr::memory_resource *memory)
        : positions(memory), normals(memory), uvs(memory), ubyte(memory), real(memory), indices(memory)
    {
    }
    Array<float> positions, normals, uvs;
    Array<Ubyte4> ubyte;
    Array<Real4> real;
    Array<uint16_t> indices;
};

// Scratch memory of one individual: colours in the renderer's format, and matrix products.
struct Scratch {
    static constexpr uint32_t batch_vertices = 1024, batch_indices = 3072;  // small enough for a processor's cache

    explicit Scratch(std::pmr::memory_resource *memory)
        : ubyte(memory),
          ubyte_table(memory),
          real(memory),
          real_table(memory),
          chain(memory),
          batch(memory),
          shadow(memory)
    {
    }
    // These only grow; they throw std::bad_alloc.
    void reserve(ColourFormat format, uint32_t vertices, uint32_t slots);
    void reserve_chain(uint32_t depth);
    void reserve_batch(ColourFormat format);

    Array<Ubyte4> ubyte;  // one per vertex
    // One per slot (model::Level::slots) or per colour entry of a FlatLevel.
    Array<Ubyte4> ubyte_table;
    Array<Real4> real;
    Array<Real4> real_table;
    Array<math::Affine> chain;  // products of nodes, one per depth: see MatrixWalk
    BatchArrays batch;
    ShadowArrays shadow;
};

struct Individual {
    const draw::Item *item = nullptr;
    const model::Level *level = nullptr;
    const PreparedTemplate *prepared = nullptr;
    const PreparedLevel *ready = nullptr;
    const uint8_t *zone_rgb = nullptr;
    draw::Vertices vertices;
    uint64_t parts = 0;               // parts of the level to draw now; only existing ones
    const uint32_t *own = nullptr;    // the texture that the host bound in place of the template's, or null
    const uint32_t *close = nullptr;  // textures of its own, one for each surface of the item's level, or null
    bool one_colour = false;          // all its zones have one colour, and its level has a plain form

    bool whole() const { return parts == every_part_of(*level); }
};

// Writes one colour per vertex of a level, from the slots of a surface. `table` has space for the slots.
void slot_colours(const Individual &individual, uint32_t surface_index, Array<Ubyte4> &table, Ubyte4 *out);
void slot_colours(const Individual &individual, uint32_t surface_index, Array<Real4> &table, Real4 *out);

// Writes one colour per vertex of a FlatLevel: zone colour times texel.
void flat_colours(const Individual &individual, Array<Ubyte4> &table, Ubyte4 *out);
void flat_colours(const Individual &individual, Array<Real4> &table, Real4 *out);

class Canvas
{
public:
    Canvas(const Gl11 &gl, const RendererOptions &options, GlState &state, Scratch &scratch, DrawStats &stats)
        : gl_(gl), options_(options), state_(state), scratch_(scratch), stats_(stats)
    {
    }
    const RendererOptions &options() const { return options_; }

    void bind_vertices(const Individual &individual);  // its matrix and arrays, without colours

    // True if the slice has a triangle of a drawn part.
    static bool any(const Individual &individual, const IndexSlice &slice)
    {
        return individual.whole() ? slice.range.count != 0
                                  : any_of(slice, individual.parts, part_count_of(*individual.level));
    }

    // The state that a surface of an individual needs, without the alpha test.
    static SurfaceState state_of(const Individual &individual, const model::Surface &surface);
    void apply(const SurfaceState &wanted) { state_.apply(wanted); }

    // Sets one zone's colour for the next triangles: by glColor, or by an array if the template has vertex colours.
    void use_zone_colour(const Individual &individual, uint32_t surface_index, const ZoneTest &test);

    // Gives every vertex of a surface's fused triangles the colour and threshold of its slot.
    void use_slot_colours(const Individual &individual, uint32_t surface_index);

    // Gives every source vertex the template's colour there, as under white zones; white if it has none.
    void use_own_colours(const Individual &individual);

    // One call if all parts are drawn, else one for each run of neighbouring parts.
    void triangles(const Individual &individual, const IndexSlice &slice);
    void plain_triangles(const Individual &individual, uint32_t surface_index);

private:
    struct Indices {
        const Array<uint16_t> &shorts;  // empty: the others
        const Array<uint32_t> &ints;
    };
    void send(const Individual &individual, const IndexSlice &slice, const Indices &indices);
    void draw_elements(const Indices &indices, model::IndexRange range);

    const Gl11 &gl_;
    const RendererOptions &options_;
    GlState &state_;
    Scratch &scratch_;
    DrawStats &stats_;
};

}  // namespace claque::passes
