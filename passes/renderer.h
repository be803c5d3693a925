// Draw lists to pixels, GL 1.1 only; one per GL context. S1 3, SPEC 3 and 4.
//
// Threads: the one whose context is current, for every call but abandon(). Nothing here throws; draw() allocates
// nothing and makes no GL object.
#pragma once

#include "passes/canvas.h"
#include "passes/preflight.h"
#include "passes/shadow.h"
#include "passes/shadow_drawer.h"

namespace claque::passes
{

class Renderer
{
public:
    Renderer(std::pmr::memory_resource *memory, const RendererOptions &options)
        : options_(options), memory_(memory), templates_(memory), scratch_(memory)
    {
    }
    Renderer(const Renderer &) = delete;
    Renderer &operator=(const Renderer &) = delete;

    // Once, first. GL: queries only.
    // Fails: CLQ_ARGUMENT (KeyTest::equal with another strategy than per-zone), CLQ_GL_MISSING.
    base::Status open(GetProcAddress get_proc_address, void *user);

    // Brings a template to GL; again is harmless. It must live until destroy() or abandon().
    // Fails: CLQ_LIMIT (texture size), CLQ_KEY_RESOLUTION, CLQ_ARGUMENT, CLQ_GL_STATE, CLQ_GL_MISSING,
    // CLQ_OUT_OF_MEMORY; nothing is changed then.
    base::Status prepare(const model::Template &tmpl);

    // How a prepared template is drawn: the strategy asked for, or binned where fused cannot tell its zones apart.
    Strategy strategy_of(const model::Template &tmpl) const;

    LuminanceStep step_of(const model::Template &tmpl) const;  // all 0 unless prepared with linear_clean

    // Draws all items in their order; a list that shows nothing touches nothing. `out_stats` may be null.
    // Fails: CLQ_ARGUMENT (a template that is not prepared, by name), CLQ_GL_STATE, CLQ_GL_MISSING; nothing is drawn or
    // changed then. CLQ_OUT_OF_MEMORY: the vertex server had no room for an individual; all others are drawn.
    // CLQ_GL_STATE also: hooks left what GL 1.1 cannot undo, a program in use for example: their individual is not
    // drawn, nor is anybody after it if it is still there after the second hook.
    base::Status draw(const draw::DrawList &list, DrawStats *out_stats);

    // Darkens the ground by the shadows of all items, of those kept for it alone too; GL's state is afterwards as it
    // was, whatever the guard mode. `out_stats` may be null.
    // Fails: as draw(); CLQ_GL_STATE also where the target lacks the stencil bit that is lent. CLQ_OUT_OF_MEMORY also
    // where there is no room for a mask of the viewport; nothing is drawn then.
    base::Status draw_shadows(const draw::DrawList &list, const ShadowOptions &options, ShadowStats *out_stats);

    // Deletes the textures; the context must be current. May be opened again afterwards.
    void destroy();
    // The context is lost: forgets everything without one GL call. May be opened again in another one.
    void abandon();

private:
    base::Status check_items(const draw::DrawList &list) const;
    base::Status check_item(const draw::DrawList &list, const draw::Item &item, const PreparedTemplate &prepared) const;
    StackEntries stack_entries_for(const draw::DrawList &list) const;
    base::Status check_shadows(const draw::DrawList &list, const ShadowOptions &options, ShadowTarget &target);
    base::Status add(const model::Template &tmpl);

    RendererOptions options_;
    std::pmr::memory_resource *memory_;
    Gl11 gl_;
    Preflight preflight_;
    bool open_ = false;
    Array<PreparedTemplate> templates_;
    Scratch scratch_;
};

}  // namespace claque::passes
