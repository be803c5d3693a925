// Visibility pictures of Renderer: everything that can fail is checked before anything is drawn.
#include <algorithm>
#include <new>

#include "passes/guard.h"
#include "passes/list_drawer.h"
#include "passes/renderer.h"

namespace claque::passes
{
namespace
{

constexpr gl::Enum red_bits = 0x0D52, green_bits = 0x0D53, blue_bits = 0x0D54, depth_bits = 0x0D56;

base::Status check_bits(const Gl11 &gl)
{
    const int32_t red = integer(gl, red_bits), green = integer(gl, green_bits), blue = integer(gl, blue_bits);
    if (std::min({red, green, blue}) < 8)
        return base::Status::bad(CLQ_GL_STATE,
                                 "the picture has %d, %d and %d bits of red, green and blue: numbers need 8 of each",
                                 red, green, blue);
    if (integer(gl, depth_bits) > 0) return base::Status::good();
    return base::Status::bad(CLQ_GL_STATE, "the target has no depth buffer: it cannot tell which triangle is in front");
}

}  // namespace

base::Status Renderer::check_visibility(const draw::DrawList &list)
{
    if (base::Status status = check_items(list); !status.ok()) return status;
    if (base::Status status = preflight_.check_draw(gl_, stack_entries_of(Guard::full)); !status.ok()) return status;
    if (base::Status status = check_bits(gl_); !status.ok()) return status;
    try {
        visibility_.reserve();
    } catch (const std::bad_alloc &) {
        return base::Status::bad(CLQ_OUT_OF_MEMORY, "no memory for the corners of triangles");
    }
    return holes_.prepare(gl_, preflight_, list);
}

base::Status Renderer::draw_visibility(const draw::DrawList &list, const VisibilityOptions &options,
                                       DrawStats *out_stats)
{
    DrawStats stats;
    base::Status status = open_ ? check_visibility(list)
                                : base::Status::bad(CLQ_GL_MISSING, "the renderer has no GL functions: it is not open");
    if (status.ok() && std::any_of(list.items.begin(), list.items.end(), shows)) {
        const Multisample multisample = preflight_.multisample(false);
        const StateGuard guard(gl_, Guard::full, multisample);
        status = VisibilityDrawer(gl_, holes_, visibility_, list, options, stats).draw(multisample);
    }
    if (open_) status = still_current(gl_, status);
    if (out_stats) *out_stats = stats;
    return status;
}

}  // namespace claque::passes
