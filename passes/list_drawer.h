// One draw of one list: its items one after the other, under one guard.
#pragma once

#include "passes/batch.h"
#include "passes/canvas.h"
#include "passes/preflight.h"

namespace claque::passes
{

// Nothing is drawn, and nothing asked, for who is kept for the shadow alone, has no triangles at its level, or none in
// the parts that are seen.
bool shows(const draw::Item &item);

class ListDrawer
{
public:
    ListDrawer(const Gl11 &gl, const Preflight &preflight, const RendererOptions &options,
               const Array<PreparedTemplate> &templates, Scratch &scratch, const draw::DrawList &list,
               DrawStats &stats);

    // Everything has been checked. Fails: CLQ_OUT_OF_MEMORY (the vertex server had no room), CLQ_GL_STATE (hooks left
    // something that cannot be undone); the first of it.
    base::Status draw();

private:
    enum class Next { go_on, stop };

    bool make(const draw::Item &item, Individual &individual) const;
    Next draw_between_hooks(Individual &individual, base::Status &first);
    void draw_individual(const Individual &individual);
    void flush_gl();

    const Gl11 &gl_;
    const Preflight &preflight_;
    const Array<PreparedTemplate> &templates_;
    Guard guard_;
    Scratch &scratch_;
    const draw::DrawList &list_;
    DrawStats &stats_;
    GlState state_;
    Canvas canvas_;
    Batch batch_;
    uint32_t room_ = 0;  // for matrices; asked where an item wants it
    uint32_t flush_triangles_, flushed_ = 0;
};

}  // namespace claque::passes
