// Checks before a draw, by queries alone, whether state that the host has left on would spoil the picture or make GL
// read past arrays, and names it. It never calls glGetError, since the host's errors are the host's. It queries nothing
// newer than GL 1.1 unless the version or extension string promises it, so that it causes no error either.
//
// GL 1.1 has no query for an open glBegin, for texturing and texture coordinate arrays of units other than 0, and for
// generic vertex attributes. Hosts must leave those off.
#pragma once

#include "passes/gl11.h"
#include "passes/gl_state.h"
#include "passes/options.h"

namespace claque::passes
{

// Entries that a draw needs on the attribute stacks.
struct StackEntries {
    int32_t attributes = 0;
    int32_t client = 0;
};

class Preflight
{
public:
    // Reads the version and extension strings of the current context. Fails with CLQ_GL_MISSING for a core profile,
    // which has no fixed function.
    base::Status learn(const Gl11 &gl);

    // Fails with CLQ_GL_MISSING (no current context) or CLQ_GL_STATE (names the first state that would spoil the draw).
    base::Status check_draw(const Gl11 &gl, StackEntries entries) const;
    base::Status check_target(const Gl11 &gl) const;  // the same without the stacks
    base::Status check_upload(const Gl11 &gl) const;

    Multisample multisample(bool hosts) const
    {
        return !multisample_ ? Multisample::missing : hosts ? Multisample::hosts : Multisample::off;
    }

private:
    static constexpr int max_spoilers = 24;
    base::Status check(const Gl11 &gl, bool upload) const;

    bool known_[max_spoilers] = {false};  // entries of the list in preflight.cpp that this GL has
    bool multisample_ = false;
};

}  // namespace claque::passes
