// A template prepared for one GL context: texture names, the alpha tests and thresholds of each zone, and indices of
// the smallest type. prepare() makes it once; draws only read it.
#pragma once

#include "lib/model/template.h"
#include "passes/gl11.h"
#include "passes/options.h"

namespace claque::passes
{

using model::Array;

// How a strategy selects exactly one zone of a texture. The options decide which member is used.
struct ZoneTest {
    uint32_t zone = 0;              // of the template
    float reference = 0;            // per-zone, binned: the alpha reference for GL_GEQUAL or, if requested, GL_EQUAL
    uint8_t threshold_ubyte = 255;  // fused: vertex alpha of a raised copy
    float threshold_real = 1;
};

// One image of a texture as close textures show it (close_image.h).
struct CloseImage {
    static constexpr uint32_t hole = 0x80000000;

    explicit CloseImage(std::pmr::memory_resource *memory) : sources(memory) {}
    uint32_t width = 0, height = 0;
    uint64_t bytes = 0;       // in GL, with all mip levels
    Array<uint32_t> sources;  // per texel: the texel of the template's image that it takes; `hole` is added in holes
};

struct PreparedTexture {
    explicit PreparedTexture(std::pmr::memory_resource *memory)
        : names(memory), linear_names(memory), tests(memory), close(memory)
    {
    }
    // GL names, one per texture set (one if all sets show the same); then as many for each step of smooth_levels.h.
    Array<uint32_t> names;
    uint32_t smooth_steps = 0;
    Array<uint32_t> linear_names;  // GL names of copies filtered GL_LINEAR; empty unless requested
    float hole_reference = 0;      // GL_GEQUAL: the lowest key passes, a hole fails
    float fused_reference = 0;     // GL_GEQUAL: the single test of the fused strategy
    Array<ZoneTest> tests;         // as model::Texture::keys
    Array<CloseImage> close;       // as `names`; empty if individuals get no textures of their own

    size_t sets() const { return names.size() / (1 + smooth_steps); }
    uint32_t name_of(uint32_t set, bool linear, uint32_t smooth_step) const
    {
        const size_t at = set < sets() ? set : 0;
        return linear ? linear_names[at] : names[smooth_step * sets() + at];
    }
};

struct VertexRange {
    uint32_t first = 0, end = 0;
};

// The vertices of the triangles of one part of one surface.
struct PartVertexRanges {
    VertexRange sources, copies;
};

// A node on the path to a part, for GL's matrix stack (S0 6.2.2, fTrack). Steps are in depth-first order.
struct MatrixStep {
    uint32_t node = 0;
    uint32_t depth = 1;  // 1 for a root
    uint32_t next = 0;   // the step after all descendants of this node
    uint64_t own = 0;    // parts on this node
    uint64_t below = 0;  // parts on this node and its descendants
};

// A level for GL_FLAT, see flat.h; empty if the level is drawn otherwise. A colour entry is a zone and the texel that
// multiplies its colour.
struct FlatLevel {
    explicit FlatLevel(std::pmr::memory_resource *memory)
        : vertices(memory), colour_entries(memory), indices(memory), zones(memory), rgb(memory)
    {
    }
    Array<uint16_t> vertices;        // of the level
    Array<uint16_t> colour_entries;  // one per vertex
    // Indices of `vertices`. The last corner is the provoking vertex: the triangle shows its colour entry, and its
    // normal is the sum over the triangles it provokes.
    Array<uint16_t> indices;
    Array<uint32_t> zones;  // one per colour entry: index of the template
    uint32_t sets = 1;      // texture sets that differ
    Array<uint8_t> rgb;     // three bytes per set of a colour entry

    const uint8_t *texel(uint32_t colour_entry, uint32_t set) const
    {
        return &rgb[3 * (size_t(colour_entry) * sets + (set < sets ? set : 0))];
    }
};

// A level without zones (plain.h): every triangle once, by source vertices; empty if it is batched.
struct PlainLevel {
    explicit PlainLevel(std::pmr::memory_resource *memory)
        : short_indices(memory), indices(memory), ranges(memory), firsts(memory)
    {
    }
    Array<uint16_t> short_indices;  // one of these two is empty
    Array<uint32_t> indices;
    Array<model::IndexRange> ranges;  // per surface
    Array<uint32_t> firsts;           // per surface, as IndexSlice::firsts

    bool empty() const { return ranges.empty(); }
};

struct PreparedLevel {
    explicit PreparedLevel(std::pmr::memory_resource *memory)
        : short_indices(memory),
          fused_vertices(memory),
          part_vertex_ranges(memory),
          positions(memory),
          normals(memory),
          steps(memory),
          flat(memory),
          filtered(memory),
          linear(memory),
          smooth(memory),
          shadow_indices(memory),
          shadow_firsts(memory),
          plain(memory)
    {
    }
    Array<uint16_t> short_indices;               // as model::Level::indices; empty: those are used
    Array<VertexRange> fused_vertices;           // per surface: the vertices of its fused triangles
    Array<PartVertexRanges> part_vertex_ranges;  // per surface and part; empty if the level has one part

    // If PreparedTemplate::rigid: each vertex, copies included, in the space of its part's node.
    Array<float> positions, normals;
    Array<MatrixStep> steps;

    bool batched = false;  // several of its individuals are drawn with one call
    FlatLevel flat;        // not empty: drawn GL_FLAT

    // If clean triangles are filtered (linear_clean.h): the level with its surfaces split in two, in place of the
    // template's, and for each of these surfaces whether it is the filtered one. Otherwise both are empty.
    Array<model::Level> filtered;
    Array<uint8_t> linear;
    const model::Level &drawn(const model::Level &level) const { return filtered.empty() ? level : filtered[0]; }

    Array<uint8_t> smooth;  // per surface as drawn: its step (smooth_levels.h); empty: 0

    Array<uint32_t> shadow_indices;  // every triangle once, part by part, by source vertices: see ShadowDrawer
    Array<uint32_t> shadow_firsts;   // where each part begins, and the end

    PlainLevel plain;
    bool shows_close = false;  // individuals may show close textures
};

struct PreparedTemplate {
    explicit PreparedTemplate(std::pmr::memory_resource *memory) : zone_rgb(memory), textures(memory), levels(memory) {}
    const model::Template *source = nullptr;
    Strategy strategy = Strategy::fused;  // the renderer's, or binned if fused cannot distinguish the zones
    bool rigid = false;                   // GL's matrix stack can transform its parts: see draw::Item::locals
    Array<uint8_t> zone_rgb;              // the template's default colours, rounded
    Array<PreparedTexture> textures;
    Array<PreparedLevel> levels;
    float close_distance_m = 0;  // individuals from here on show no close textures (close_distance.h)
    LuminanceStep step;          // all 0 if no triangle is filtered
};

// Prepares everything that needs no GL. `alpha_bits` is GL's resolution of this template's texture alpha. Fails with
// CLQ_ARGUMENT (an index out of range) or CLQ_KEY_RESOLUTION (no strategy distinguishes the zones). Throws
// std::bad_alloc.
base::Status prepare_without_gl(PreparedTemplate &out, const model::Template &source, const RendererOptions &options,
                                int alpha_bits);

// These prepare one level. prepare_rigid returns false and changes nothing if GL cannot transform its parts.
bool prepare_rigid(PreparedLevel &out, const model::Template &source, const model::Level &level);
void prepare_ranges(PreparedLevel &out, const model::Level &level);
void prepare_shadow(PreparedLevel &out, const model::Level &level);

// The prepared form of a template, or null.
const PreparedTemplate *find(const Array<PreparedTemplate> &templates, const model::Template *tmpl);

// Finds the smallest alpha resolution that GL has for the template's textures, and checks that GL takes their sizes.
// Fails with CLQ_LIMIT, naming the texture's size and GL's. Changes nothing.
base::Status probe_textures(const Gl11 &gl, const model::Template &source, int &alpha_bits);

// Uploads the textures, or none of them: CLQ_OUT_OF_MEMORY where GL took no image. All else was checked before.
base::Status upload_textures(const Gl11 &gl, PreparedTemplate &prepared);
void delete_textures(const Gl11 &gl, PreparedTemplate &prepared);

}  // namespace claque::passes
