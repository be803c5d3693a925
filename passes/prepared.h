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
    explicit PreparedTexture(std::pmr::memory_resource *memory) : tests(memory) {}
    uint32_t name = 0;          // GL's
    float hole_reference = 0;   // GL_GEQUAL: passes the lowest key, stops a hole
    float fused_reference = 0;  // GL_GEQUAL: the one test of the fused strategy
    Array<ZoneTest> tests;      // as model::Texture::keys
};

struct VertexRange {
    uint32_t first = 0, end = 0;
};

struct PreparedLevel {
    explicit PreparedLevel(std::pmr::memory_resource *memory) : short_indices(memory), fused_vertices(memory) {}
    Array<uint16_t> short_indices;      // as model::Level::indices, or empty: those are used
    Array<VertexRange> fused_vertices;  // per surface: what its fused triangles reach
};

struct PreparedTemplate {
    explicit PreparedTemplate(std::pmr::memory_resource *memory) : zone_rgb(memory), textures(memory), levels(memory) {}
    const model::Template *source = nullptr;
    Strategy strategy = Strategy::fused;  // the renderer's, or binned where fused cannot tell the zones apart
    Array<uint8_t> zone_rgb;              // the template's own colours, rounded
    Array<PreparedTexture> textures;
    Array<PreparedLevel> levels;
};

// Everything of it that needs no GL. `alpha_bits` is how finely GL keeps this template's texture alpha.
// Fails: CLQ_ARGUMENT (an index out of range), CLQ_KEY_RESOLUTION (no strategy tells the zones apart). Throws
// std::bad_alloc.
base::Status prepare_without_gl(PreparedTemplate &out, const model::Template &source, const RendererOptions &options,
                                int alpha_bits);

// The least bits of alpha that GL keeps for the template's textures, and whether it takes their sizes at all.
// Fails: CLQ_LIMIT, naming the texture's size and GL's. Changes nothing.
base::Status probe_textures(const Gl11 &gl, const model::Template &source, int &alpha_bits);

// Brings the textures to GL. Throws and fails at nothing: what can has been asked before.
void upload_textures(const Gl11 &gl, PreparedTemplate &prepared);
void delete_textures(const Gl11 &gl, PreparedTemplate &prepared);

}  // namespace claque::passes
