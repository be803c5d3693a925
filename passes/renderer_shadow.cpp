// Shadows of Renderer: everything that can fail is checked before anything is drawn.
#include <algorithm>
#include <new>

#include "passes/guard.h"
#include "passes/renderer.h"

namespace claque::passes
{
namespace
{

base::Status check_stencil(const Gl11 &gl, int32_t bit)
{
    if (bit < 0) return base::Status::good();
    int32_t bits = 0;
    gl.GetIntegerv(gl::stencil_bits, &bits);
    if (bit < bits) return base::Status::good();
    return base::Status::bad(CLQ_GL_STATE, "stencil bit %d is lent to shadows, but the target has %d stencil bits", bit,
                             bits);
}

}  // namespace

base::Status Renderer::check_shadows(const draw::DrawList &list, const ShadowOptions &options, ShadowTarget &target)
{
    for (const draw::Item &item : list.items) {
        if (!item.shadow_only) continue;
        const PreparedTemplate *prepared = find(templates_, item.tmpl);
        if (!prepared)
            return base::Status::bad(CLQ_ARGUMENT, "the template '%s' has not been prepared for this renderer",
                                     item.tmpl ? item.tmpl->name.c_str() : "(none)");
        if (base::Status status = check_item(item, *prepared); !status.ok()) return status;
    }
    if (base::Status status = preflight_.check_draw(gl_, stack_entries_of(Guard::full)); !status.ok()) return status;
    if (base::Status status = check_stencil(gl_, options.stencil_bit); !status.ok()) return status;
    int32_t box[4] = {0, 0, 0, 0};
    gl_.GetIntegerv(gl::viewport, box);
    target.width = std::max(box[2], 0), target.height = std::max(box[3], 0);
    if (options.stencil_bit >= 0) return base::Status::good();
    try {
        scratch_.shadow.mask.reserve(target.width, target.height);
    } catch (const std::bad_alloc &) {
        return base::Status::bad(CLQ_OUT_OF_MEMORY, "no memory for a shadow mask of %d x %d pixels", target.width,
                                 target.height);
    }
    return base::Status::good();
}

base::Status Renderer::draw_shadows(const draw::DrawList &list, const ShadowOptions &options, ShadowStats *out_stats)
{
    ShadowStats stats;
    ShadowTarget target;
    base::Status status = open_ ? check_items(list)
                                : base::Status::bad(CLQ_GL_MISSING, "the renderer has no GL functions: it is not open");
    if (status.ok()) status = check_shadows(list, options, target);
    const bool any = target.width > 0 && target.height > 0 && options.darkness > 0 &&
                     std::any_of(list.items.begin(), list.items.end(), casts);
    if (status.ok() && any)
        status = ShadowDrawer(gl_, preflight_, templates_, scratch_, list, options, target, stats).draw();
    if (open_) status = still_current(gl_, status);
    if (out_stats) *out_stats = stats;
    return status;
}

}  // namespace claque::passes
