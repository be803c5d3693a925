#include "passes/hook_frame.h"

#include "lib/base/host_call.h"
#include "passes/guard.h"

namespace claque::passes
{
HookFrame::HookFrame(const Gl11 &gl, const Preflight &preflight, GlState &state, Multisample multisample,
                     const draw::DrawList &list, const draw::Item &item)
    : gl_(gl),
      preflight_(preflight),
      state_(state),
      multisample_(multisample),
      samples_(gl, multisample),
      list_(list),
      item_(item)
{
    state_.end();
    gl_.BindTexture(gl::texture_2d, 0);  // first: the pop restores parameters to the texture that was bound at the push
    state_.forget();
    gl_.PushAttrib(gl::all_attrib_bits);
    gl_.PushClientAttrib(gl::all_client_attrib_bits);
    found_ = depths();
}

HookFrame::Depths HookFrame::depths() const
{
    return {integer(gl_, gl::attrib_stack_depth), integer(gl_, gl::client_attrib_stack_depth),
            integer(gl_, gl::modelview_stack_depth), integer(gl_, gl::projection_stack_depth),
            integer(gl_, gl::texture_stack_depth)};
}

void HookFrame::offer() const
{
    gl_.BindTexture(gl::texture_2d, 0);
    disable_arrays(gl_);
    gl_.MatrixMode(gl::modelview);
    gl_.LoadMatrixf(item_.model_view);
}

base::Status HookFrame::named(const base::Status &status, const char *which) const
{
    if (status.ok()) return status;
    return base::Status::bad(status.code, "actor %u: after its hook '%s', %s", item_.actor_index + 1, which,
                             status.text);
}

template <class Call>
void HookFrame::call(const char *name, const Call &hook)
{
    base::HostCalls calls;  // the second hook is called even if the first threw
    calls.run(name, item_.actor_index + 1, hook);
    if (thrown_.ok()) thrown_ = calls.status();
}

base::Status HookFrame::before()
{
    const draw::Hooks &hooks = *item_.hooks;
    if (!hooks.before) return base::Status::good();
    offer();
    call("the hook 'before'",
         [&] { has_texture_ = hooks.before(hooks.user, item_.actor_index + 1, item_.generation) != 0; });
    end_modes();
    if (has_texture_) texture_ = static_cast<uint32_t>(integer(gl_, gl::texture_binding_2d));
    const base::Status status = preflight_.check_target(gl_);
    if (status.ok()) state_.begin(list_.projection, multisample_);
    return named(status, "before");
}

base::Status HookFrame::after()
{
    const draw::Hooks &hooks = *item_.hooks;
    if (hooks.after) {
        offer();
        call("the hook 'after'", [&] { hooks.after(hooks.user, item_.actor_index + 1, item_.generation); });
        end_modes();
    }
    level_attributes();
    gl_.PopClientAttrib();
    gl_.PopAttrib();
    samples_.restore();
    level_matrices();
    const base::Status status = preflight_.check_target(gl_);
    state_.begin(list_.projection, multisample_);
    return named(status, hooks.after ? "after" : "before");
}

void HookFrame::end_modes() const
{
    if (integer(gl_, gl::list_index) != 0) gl_.EndList();
    if (integer(gl_, gl::render_mode) != static_cast<int32_t>(gl::render)) gl_.RenderMode(gl::render);
}

// Entries that a hook popped too many are lost. The depths are restored, so that the host's own entries are safe.
void HookFrame::level_attributes() const
{
    int32_t depth = integer(gl_, gl::attrib_stack_depth);
    for (; depth > found_.attributes; --depth) gl_.PopAttrib();
    for (; depth < found_.attributes; ++depth) gl_.PushAttrib(gl::all_attrib_bits);
    depth = integer(gl_, gl::client_attrib_stack_depth);
    for (; depth > found_.client; --depth) gl_.PopClientAttrib();
    for (; depth < found_.client; ++depth) gl_.PushClientAttrib(gl::all_client_attrib_bits);
}

void HookFrame::level_matrices() const
{
    const Depths now = depths();
    const auto level = [&](gl::Enum stack, int32_t depth, int32_t found) {
        if (depth == found) return;
        gl_.MatrixMode(stack);
        for (; depth > found; --depth) gl_.PopMatrix();
        for (; depth < found; ++depth) gl_.PushMatrix();
    };
    level(gl::modelview, now.modelview, found_.modelview);
    level(gl::projection, now.projection, found_.projection);
    level(gl::texture, now.texture, found_.texture);
}

}  // namespace claque::passes
