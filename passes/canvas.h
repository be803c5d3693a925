// What the three strategies draw with: one individual at a time, its colours, its ranges of triangles. Allocates
// nothing; the room for colours is reserved when a template is prepared.
#pragma once

#include "lib/draw/draw_list.h"
#include "passes/gl_state.h"
#include "passes/prepared.h"

#include <array>

namespace claque::passes
{

using Ubyte4 = std::array<uint8_t, 4>;
using Real4 = std::array<float, 4>;

// Colours of one individual at a time, in the format that the renderer was asked for.
struct Scratch {
    explicit Scratch(std::pmr::memory_resource *memory)
        : ubyte(memory), ubyte_table(memory), real(memory), real_table(memory)
    {
    }
    void reserve(ColourFormat format, uint32_t vertices, uint32_t slots);  // grows only; throws std::bad_alloc

    Array<Ubyte4> ubyte;        // one a vertex
    Array<Ubyte4> ubyte_table;  // one a slot, see model::Level::slots
    Array<Real4> real;
    Array<Real4> real_table;
};

struct Individual {
    const draw::Item *item = nullptr;
    const model::Level *level = nullptr;
    const PreparedTemplate *prepared = nullptr;
    const PreparedLevel *ready = nullptr;
    const uint8_t *zone_rgb = nullptr;
    draw::Vertices vertices;
};

class Canvas
{
public:
    Canvas(const Gl11 &gl, const RendererOptions &options, GlState &state, Scratch &scratch, DrawStats &stats)
        : gl_(gl), options_(options), state_(state), scratch_(scratch), stats_(stats)
    {
    }
    const RendererOptions &options() const { return options_; }

    void place(const Individual &who);  // its matrix and its arrays; colours apart

    // The state that a surface of an individual asks for, without an alpha test.
    static SurfaceState state_of(const Individual &who, const model::Surface &surface);
    void apply(const SurfaceState &wanted) { state_.apply(wanted); }

    // One zone's colour for what is drawn next: glColor, or an array where the template has vertex colours.
    void use_zone_colour(const Individual &who, const ZoneTest &test);

    // Every vertex of a surface's fused triangles gets the colour and the threshold of its slot.
    void use_slot_colours(const Individual &who, uint32_t surface_index);

    void triangles(const Individual &who, model::IndexRange range);

private:
    const Gl11 &gl_;
    const RendererOptions &options_;
    GlState &state_;
    Scratch &scratch_;
    DrawStats &stats_;
};

}  // namespace claque::passes
