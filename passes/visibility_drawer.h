// Draws a visibility picture: each triangle of a list in the colour of its number, flat, unlit and unblended.
#pragma once

#include "lib/draw/triangle_numbers.h"
#include "lib/draw/vertex_source.h"
#include "passes/gl_state.h"
#include "passes/hole_textures.h"
#include "passes/options.h"

namespace claque::passes
{

struct VisibilityOptions {
    uint32_t first_number = 1;
    bool upper_bits = false;         // colours hold the bits above the lower 24
    const uint8_t *drawn = nullptr;  // [items] 0: left out; null: all are drawn
    draw::VertexSource *placed_by_gl = nullptr;
};

// Corners of triangles, three vertices of their own each.
struct VisibilityArrays {
    explicit VisibilityArrays(std::pmr::memory_resource *memory)
        : positions(memory), uvs(memory), colours(memory), indices(memory)
    {
    }
    static constexpr uint32_t max_corners = 3 * 8192;
    void reserve();  // throws std::bad_alloc

    model::Array<float> positions;   // 3 a corner
    model::Array<float> uvs;         // 2 a corner
    model::Array<uint8_t> colours;   // RGBA a corner
    model::Array<uint16_t> indices;  // 0, 1, 2, ...
};

class VisibilityDrawer
{
public:
    VisibilityDrawer(const Gl11 &gl, const HoleTextures &holes, VisibilityArrays &arrays, const draw::DrawList &list,
                     const VisibilityOptions &options, DrawStats &stats)
        : gl_(gl), holes_(holes), arrays_(arrays), list_(list), options_(options), stats_(stats)
    {
    }

    // All state has been checked and is guarded by the caller. Returns CLQ_OUT_OF_MEMORY for an item without vertices;
    // the others are drawn.
    base::Status draw(Multisample multisample);

private:
    void begin(Multisample multisample);
    void draw_item(const draw::Item &item, const draw::Vertices &vertices, uint64_t first);
    void set_surface(const draw::Item &item, const model::Surface &surface);
    void add(const model::Level &level, const draw::Vertices &vertices, uint32_t first_index, uint64_t number);
    void flush();

    const Gl11 &gl_;
    const HoleTextures &holes_;
    VisibilityArrays &arrays_;
    const draw::DrawList &list_;
    const VisibilityOptions &options_;
    DrawStats &stats_;
    uint32_t corners_ = 0;
    bool has_holes_ = false;
};

}  // namespace claque::passes
