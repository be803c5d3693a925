// One individual between its hooks (S0 7.1, draw::Hooks).
//
// They find GL as claque draws, matrices and all, but texture 0 bound and every client array off, so that they reach
// neither claque's textures nor its memory by mistake. Round both, all attributes are pushed: lights, fog, materials and
// whatever else claque inherits from its host act on this individual, and are gone after it. What claque's picture
// depends on is set anew after each. Stacks are levelled after the second: what one pushed the other may pop.
#pragma once

#include "lib/draw/draw_list.h"
#include "passes/gl_state.h"
#include "passes/preflight.h"

namespace claque::passes
{

// Taken on the attribute stacks while one is open.
constexpr StackEntries hook_stack_entries = {1, 1};

class HookFrame
{
public:
    HookFrame(const Gl11 &gl, const Preflight &preflight, GlState &state, const draw::DrawList &list,
              const draw::Item &item);

    // The first hook, if there is one. Fails: CLQ_GL_STATE (it left something that GL 1.1 cannot undo and that would
    // spoil the picture: the individual is not drawn).
    base::Status before();
    // The texture that it wants used, or null.
    const uint32_t *texture() const { return has_texture_ ? &texture_ : nullptr; }

    // The second hook, if there is one; then everything is as before the first. Once, always. Fails: CLQ_GL_STATE
    // (likewise: nothing more can be drawn).
    base::Status after();

private:
    struct Depths {
        int32_t attributes, client, modelview, projection, texture;
    };
    Depths depths() const;
    void offer() const;      // GL as a hook finds it
    void end_modes() const;  // an open display list, selection, feedback
    void level_attributes() const;
    void level_matrices() const;
    base::Status named(const base::Status &status, const char *which) const;

    const Gl11 &gl_;
    const Preflight &preflight_;
    GlState &state_;
    const draw::DrawList &list_;
    const draw::Item &item_;
    Depths found_;
    uint32_t texture_ = 0;
    bool has_texture_ = false;
};

}  // namespace claque::passes
