// Draws one individual between its hooks (S0 7.1, draw::Hooks).
//
// Hooks find GL as claque draws, with its matrices, but with texture 0 bound and every client array off, so that they
// cannot change claque's textures or memory by mistake. All attributes are pushed around both hooks: lights, fog,
// materials and everything else that claque inherits from its host affect this individual and are restored after it.
// State that claque's picture depends on is set again after each hook. Stack depths are restored after the second hook,
// so that it may pop what the first pushed.
#pragma once

#include "lib/draw/draw_list.h"
#include "passes/gl_state.h"
#include "passes/guard.h"
#include "passes/preflight.h"

namespace claque::passes
{

// Entries of the attribute stacks that an open frame uses.
constexpr StackEntries hook_stack_entries = {1, 1};

class HookFrame
{
public:
    HookFrame(const Gl11 &gl, const Preflight &preflight, GlState &state, Multisample multisample,
              const draw::DrawList &list, const draw::Item &item);

    // Calls the first hook, if any. Fails with CLQ_GL_STATE if the hook left state that GL 1.1 cannot undo and that
    // would spoil the picture: the individual is then not drawn.
    base::Status before();
    // The texture that the hook asks for, or null.
    const uint32_t *texture() const { return has_texture_ ? &texture_ : nullptr; }

    // Calls the second hook, if any, and restores the state before the first. To be called exactly once. Fails with
    // CLQ_GL_STATE if the hook left state that GL 1.1 cannot undo: nothing more can be drawn.
    base::Status after();

    // The first exception of a hook: CLQ_CALLBACK.
    const base::Status &thrown() const { return thrown_; }

private:
    struct Depths {
        int32_t attributes, client, modelview, projection, texture;
    };
    Depths depths() const;
    void offer() const;      // sets GL up for a hook
    void end_modes() const;  // ends an open display list, selection or feedback
    void level_attributes() const;
    void level_matrices() const;
    template <class Call>
    void call(const char *name, const Call &hook);
    base::Status named(const base::Status &status, const char *which) const;

    const Gl11 &gl_;
    const Preflight &preflight_;
    GlState &state_;
    Multisample multisample_;
    SampleSwitches samples_;
    const draw::DrawList &list_;
    const draw::Item &item_;
    Depths found_;
    uint32_t texture_ = 0;
    bool has_texture_ = false;
    base::Status thrown_;
};

}  // namespace claque::passes
