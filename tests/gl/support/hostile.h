// A host that enables everything in GL 1.1 that claque promises to cope with, and leaves nothing at its default.
#pragma once

#include "tests/gl/support/host_gl.h"

namespace gltest
{

// The memory for the hostile host's arrays and textures; must outlive its use.
class HostileHost
{
public:
    // Sets the state. Everything that claque inherits (viewport, lights, fog, clip planes, scissor, stencil, polygon
    // mode, shade model) is set too, to values that change no picture, so that tests see that claque leaves it alone.
    explicit HostileHost(const HostGl &host);

private:
    struct Calm {
    };
    HostileHost(const HostGl &host, Calm) : host_(host) {}

    void set_fragments() const;
    void set_rasterisation() const;
    void set_lighting() const;
    void set_texturing();
    void set_matrices() const;
    void set_arrays() const;
    void set_pixels() const;

    const HostGl &host_;
    uint32_t texture_[2] = {0, 0};
    float numbers_[64] = {0};
};

}  // namespace gltest
