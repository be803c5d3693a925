// Draws one list: its items in order, under one guard.
#pragma once

#include "passes/batch.h"
#include "passes/canvas.h"
#include "passes/close_textures.h"
#include "passes/preflight.h"

namespace claque::passes
{

// False for items that are shadow casters only, have no triangles at their level, or have none in their visible parts;
// no GL call is made for them.
bool shows(const draw::Item &item);

class ListDrawer
{
public:
    ListDrawer(const Gl11 &gl, const Preflight &preflight, const RendererOptions &options,
               const Array<PreparedTemplate> &templates, const CloseTextures &close, Scratch &scratch,
               const draw::DrawList &list, DrawStats &stats);

    // Everything has been checked. Returns the first failure: CLQ_OUT_OF_MEMORY (an item without vertices) or
    // CLQ_GL_STATE (hooks left something that cannot be undone).
    base::Status draw();

private:
    enum class Next { go_on, stop };

    bool make(size_t item_index, Individual &individual) const;
    Next draw_between_hooks(Individual &individual, base::Status &first);
    void draw_individual(const Individual &individual);
    void flush_gl();

    const Gl11 &gl_;
    const Preflight &preflight_;
    const Array<PreparedTemplate> &templates_;
    const CloseTextures &close_;
    Guard guard_;
    Multisample multisample_;
    Scratch &scratch_;
    const draw::DrawList &list_;
    DrawStats &stats_;
    GlState state_;
    Canvas canvas_;
    Batch batch_;
    uint32_t room_ = 0;  // for matrices; queried when an item needs it
    uint32_t flush_triangles_, flushed_ = 0;
};

}  // namespace claque::passes
