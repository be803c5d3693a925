// A host that leaves everything on that GL 1.1 has and that claque promises to cope with, and nothing at its default.
#pragma once

#include "tests/gl/support/host_gl.h"

namespace gltest
{

// What the hostile host keeps its arrays and textures in; must outlive its use.
class HostileHost
{
public:
    // Sets the state. Everything that claque inherits (viewport, lights, fog, clip planes, scissor, stencil, polygon
    // mode, shade model) is set too, harmlessly, so that its being left alone is seen.
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
