// Looks before it leaps: asks GL, by queries alone, whether something that the host has left on would spoil the picture
// or run past its arrays, and names it. Never calls glGetError (the host's errors are the host's), and asks for nothing
// beyond GL 1.1 unless the version or extension string promises it, so that no error is left behind either.
//
// What queries of GL 1.1 cannot see: an open glBegin, texturing and texture coordinate arrays of units other than 0,
// generic vertex attributes. Hosts leave those off.
#pragma once

#include "passes/gl11.h"
#include "passes/options.h"

namespace claque::passes
{

// Places that a draw takes on the attribute stacks.
struct StackEntries {
    int32_t attributes = 0;
    int32_t client = 0;
};

class Preflight
{
public:
    // Reads the version and extension strings of the current context. Fails: CLQ_GL_MISSING for a core profile, which
    // has no fixed function.
    base::Status learn(const Gl11 &gl);

    // Fails: CLQ_GL_MISSING (no current context), CLQ_GL_STATE (the first thing that would spoil it).
    base::Status check_draw(const Gl11 &gl, StackEntries entries) const;
    base::Status check_target(const Gl11 &gl) const;  // the same, the stacks apart
    base::Status check_upload(const Gl11 &gl) const;

    bool has_multisample() const { return multisample_; }

private:
    static constexpr int max_spoilers = 24;
    base::Status check(const Gl11 &gl, bool upload) const;

    bool known_[max_spoilers] = {false};  // which entries of the list in preflight.cpp this GL knows
    bool multisample_ = false;
};

}  // namespace claque::passes
