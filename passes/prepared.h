// A template made ready for one GL context: textures with their names, what each zone's tests and thresholds are there,
// indices as short as they go. Made once by prepare(); draws only read it.
#pragma once

#include "lib/model/template.h"
#include "passes/gl11.h"
#include "passes/options.h"

namespace claque::passes
{

using model::Array;

// What a strategy needs to let exactly one zone of a texture through. Which of it is used depends on the options.
struct ZoneTest {
    uint32_t zone = 0;              // of the template
    float reference = 0;            // per-zone, binned: the alpha test's, for GL_GEQUAL or, if asked, GL_EQUAL
    uint8_t threshold_ubyte = 255;  // fused: vertex alpha of a raised copy
    float threshold_real = 1;
};

struct PreparedTexture {
    explicit PreparedTexture(std::pmr::memory_resource *memory) : names(memory), linear_names(memory), tests(memory) {}
    Array<uint32_t> names;         // GL's, one a texture set; one where all show the same
    Array<uint32_t> linear_names;  // the same once more, filtered GL_LINEAR; empty unless asked for
    float hole_reference = 0;      // GL_GEQUAL: passes the lowest key, stops a hole
    float fused_reference = 0;     // GL_GEQUAL: the one test of the fused strategy
    Array<ZoneTest> tests;         // as model::Texture::keys

    uint32_t name_of(uint32_t set, bool linear) const
    {
        const Array<uint32_t> &of = linear ? linear_names : names;
        return of[set < of.size() ? set : 0];
    }
};

struct VertexRange {
    uint32_t first = 0, end = 0;
};

// Vertices that the triangles of one part of one surface reach.
struct PartVertexRanges {
    VertexRange sources, copies;
};

// A node on the way to a part, for GL's matrix stack (S0 6.2.2, fTrack). In the order of a walk down the tree.
struct MatrixStep {
    uint32_t node = 0;
    uint32_t depth = 1;  // of a node that hangs in the actor's own space
    uint32_t next = 0;   // the step after all that are below this node
    uint64_t own = 0;    // parts that hang on this node
    uint64_t below = 0;  // and these with those below it
};

// A level in a colour a triangle, see flat.h; empty where it is drawn otherwise. A look is what a triangle can show: a zone, and
// the texel that its colour is multiplied by.
struct FlatLevel {
    explicit FlatLevel(std::pmr::memory_resource *memory)
        : vertices(memory), colour_entries(memory), indices(memory), zones(memory), rgb(memory)
    {
    }
    Array<uint16_t> vertices;        // of the level
    Array<uint16_t> colour_entries;  // one a vertex
    Array<uint16_t> indices;  // into `vertices`; a triangle shows the look of its last one, whose normal is the sum of
                              // those of all triangles that it is the last one of
    Array<uint32_t> zones;    // one a look: of the template
    uint32_t sets = 1;        // texture sets that differ
    Array<uint8_t> rgb;       // three a set of a look

    const uint8_t *texel(uint32_t colour_entry, uint32_t set) const
    {
        return &rgb[3 * (size_t(colour_entry) * sets + (set < sets ? set : 0))];
    }
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
          shadow_indices(memory),
          shadow_firsts(memory)
    {
    }
    Array<uint16_t> short_indices;               // as model::Level::indices, or empty: those are used
    Array<VertexRange> fused_vertices;           // per surface: what its fused triangles reach
    Array<PartVertexRanges> part_vertex_ranges;  // per surface and part; empty where the level has one

    // Where PreparedTemplate::rigid: each vertex, copies included, in the space of the node that its part hangs on.
    Array<float> positions, normals;
    Array<MatrixStep> steps;

    bool batched = false;  // its individuals are drawn several with one call
    FlatLevel flat;        // and in a colour a triangle, unless empty

    // Where clean triangles are filtered (smooth.h): the level, its surfaces parted in two, in place of the template's; and for
    // each of these surfaces whether it is the filtered one. Else both empty.
    Array<model::Level> filtered;
    Array<uint8_t> linear;
    const model::Level &drawn(const model::Level &level) const { return filtered.empty() ? level : filtered[0]; }

    Array<uint32_t> shadow_indices;  // every triangle once, part by part, by source vertices: see ShadowDrawer
    Array<uint32_t> shadow_firsts;   // where each part begins, and the end
};

struct PreparedTemplate {
    explicit PreparedTemplate(std::pmr::memory_resource *memory) : zone_rgb(memory), textures(memory), levels(memory) {}
    const model::Template *source = nullptr;
    Strategy strategy = Strategy::fused;  // the renderer's, or binned where fused cannot tell the zones apart
    bool rigid = false;                   // GL's matrix stack can place its parts: see draw::Item::locals
    Array<uint8_t> zone_rgb;              // the template's own colours, rounded
    Array<PreparedTexture> textures;
    Array<PreparedLevel> levels;
    LuminanceStep step;  // all 0 where nothing is filtered
};

// Everything of it that needs no GL. `alpha_bits` is how finely GL keeps this template's texture alpha.
// Fails: CLQ_ARGUMENT (an index out of range), CLQ_KEY_RESOLUTION (no strategy tells the zones apart). Throws
// std::bad_alloc.
base::Status prepare_without_gl(PreparedTemplate &out, const model::Template &source, const RendererOptions &options,
                                int alpha_bits);

// Of one level; the first is false where GL cannot place its parts, which leaves `out` as it was.
bool prepare_rigid(PreparedLevel &out, const model::Template &source, const model::Level &level);
void prepare_ranges(PreparedLevel &out, const model::Level &level);
void prepare_shadow(PreparedLevel &out, const model::Level &level);

// Of the templates prepared, or null.
const PreparedTemplate *find(const Array<PreparedTemplate> &templates, const model::Template *tmpl);

// The least bits of alpha that GL keeps for the template's textures, and whether it takes their sizes at all.
// Fails: CLQ_LIMIT, naming the texture's size and GL's. Changes nothing.
base::Status probe_textures(const Gl11 &gl, const model::Template &source, int &alpha_bits);

// Brings the textures to GL. Throws and fails at nothing: what can has been asked before.
void upload_textures(const Gl11 &gl, PreparedTemplate &prepared);
void delete_textures(const Gl11 &gl, PreparedTemplate &prepared);

}  // namespace claque::passes
