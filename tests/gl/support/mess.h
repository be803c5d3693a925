// What a callback of a host may do to GL between two individuals, at its worst.
#pragma once

#include "tests/gl/support/hostile.h"

#include <memory>
#include <vector>

namespace gltest
{

class Mess
{
public:
    explicit Mess(const HostGl &host) : host_(host) {}

    // All that claque sets for its picture, otherwise: switches, functions, masks, matrices and their stacks, arrays,
    // textures, unpacking. What claque inherits from its host is set to something that changes nothing.
    void with_what_claque_sets();

    // That and all that claque inherits: lights, fog, clip planes, stencil, scissor, viewport, polygon mode ...
    void with_everything();

private:
    void leave_stacks_deep() const;
    void spoil_the_bound_texture() const;

    const HostGl &host_;
    std::vector<std::unique_ptr<HostileHost>> kept_;  // the arrays that GL has been pointed to
};

}  // namespace gltest
