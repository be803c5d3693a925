// Draws draw lists with GL 1.1; one renderer per GL context (S1 3).
//
// Threads: every call but abandon() belongs to the thread of the current context. Nothing throws. Without
// RendererOptions::close_bytes draw() allocates nothing and makes no GL object.
#pragma once

#include "passes/canvas.h"
#include "passes/close_textures.h"
#include "passes/preflight.h"
#include "passes/shadow.h"
#include "passes/shadow_drawer.h"
#include "passes/visibility_drawer.h"

namespace claque::passes
{

class Renderer
{
public:
    Renderer(std::pmr::memory_resource *memory, const RendererOptions &options)
        : options_(options),
          memory_(memory),
          templates_(memory),
          close_(memory, options),
          scratch_(memory),
          holes_(memory),
          visibility_(memory)
    {
    }
    Renderer(const Renderer &) = delete;
    Renderer &operator=(const Renderer &) = delete;

    // To be called once, first. GL: queries only. Fails with CLQ_ARGUMENT (KeyTest::equal with a strategy other than
    // per-zone) or CLQ_GL_MISSING.
    base::Status open(GetProcAddress get_proc_address, void *user);

    // Uploads a template to GL; a second call does nothing. The template must live until destroy() or abandon(). Fails
    // with CLQ_LIMIT (texture size), CLQ_KEY_RESOLUTION, CLQ_ARGUMENT, CLQ_GL_STATE, CLQ_GL_MISSING or
    // CLQ_OUT_OF_MEMORY and then changes nothing.
    base::Status prepare(const model::Template &tmpl);

    // The strategy of a prepared template: the requested one, or binned if fused cannot distinguish its zones.
    Strategy strategy_of(const model::Template &tmpl) const;

    LuminanceStep step_of(const model::Template &tmpl) const;  // all 0 unless prepared with linear_clean

    // From here on no level of a prepared template shows textures of single individuals; 0: none ever does.
    float close_distance_of(const model::Template &tmpl) const;

    // Draws all items in their order; a list that shows nothing touches nothing. `out_stats` may be null.
    // Fails: CLQ_ARGUMENT (a template that is not prepared, by name), CLQ_GL_STATE, CLQ_GL_MISSING; nothing is drawn or
    // changed then. CLQ_OUT_OF_MEMORY: an individual was left out of the list's update; all others are drawn.
    // Also: GL, or claque, has no memory for textures of single individuals; claque's own is missed before anything is
    // drawn. CLQ_GL_STATE also: hooks left what GL 1.1 cannot undo, a program in use for example: their individual is
    // not drawn, nor are later ones if the object is still there after the second hook.
    base::Status draw(const draw::DrawList &list, DrawStats *out_stats);

    // Darkens the ground by the shadows of all items, including shadow casters that are not drawn. GL's state is
    // restored in every guard mode. `out_stats` may be null. Fails as draw(); CLQ_GL_STATE also if the target lacks the
    // lent stencil bit; CLQ_OUT_OF_MEMORY also if there is no memory for a mask of the viewport, and nothing is drawn
    // then.
    base::Status draw_shadows(const draw::DrawList &list, const ShadowOptions &options, ShadowStats *out_stats);

    // Draws each triangle in the colour of its number. GL's state is restored in every guard mode. No hook is called.
    // `out_stats` may be null. Fails as draw(); CLQ_GL_STATE also if the target has less than 8 bits a channel or no
    // depth; CLQ_OUT_OF_MEMORY also if there is no memory for corners or for the holes of textures, and nothing is
    // drawn then.
    base::Status draw_visibility(const draw::DrawList &list, const VisibilityOptions &options, DrawStats *out_stats);

    // Deletes the textures; the context must be current. open() may be called again.
    void destroy();
    // For a lost context: forgets everything without a GL call. open() may be called again in another context.
    void abandon();

private:
    base::Status check_items(const draw::DrawList &list) const;
    base::Status check_item(const draw::Item &item, const PreparedTemplate &prepared) const;
    StackEntries stack_entries_for(const draw::DrawList &list) const;
    base::Status check_shadows(const draw::DrawList &list, const ShadowOptions &options, ShadowTarget &target);
    base::Status check_visibility(const draw::DrawList &list);
    base::Status add(const model::Template &tmpl);
    base::Status draw_checked(const draw::DrawList &list, DrawStats &stats);

    RendererOptions options_;
    std::pmr::memory_resource *memory_;
    Gl11 gl_;
    Preflight preflight_;
    bool open_ = false;
    Array<PreparedTemplate> templates_;
    CloseTextures close_;
    Scratch scratch_;
    HoleTextures holes_;
    VisibilityArrays visibility_;
};

}  // namespace claque::passes
