// A pixel unpack buffer of a host, which GL reads in place of texels while it is bound.
#pragma once

#include "tests/gl/support/host_gl.h"

namespace gltest
{

class UnpackBuffer
{
public:
    // Of the current context; this GL must have such buffers (GL_ARB_pixel_buffer_object).
    explicit UnpackBuffer(const HostGl &host) : bind_(host.ask<void (*)(gl::Enum, uint32_t)>("glBindBuffer"))
    {
        host.ask<void (*)(int32_t, uint32_t *)>("glGenBuffers")(1, &name_);
    }

    void bind() const { bind_(unpack, name_); }
    void unbind() const { bind_(unpack, 0); }

private:
    static constexpr gl::Enum unpack = 0x88EC;  // GL_PIXEL_UNPACK_BUFFER

    void (*bind_)(gl::Enum target, uint32_t name);
    uint32_t name_ = 0;
};

}  // namespace gltest
