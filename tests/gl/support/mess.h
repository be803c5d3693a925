// The worst that a host's callback may do to GL between two individuals.
#pragma once

#include <memory>
#include <vector>

#include "tests/gl/support/hostile.h"

namespace gltest
{

class Mess
{
public:
    explicit Mess(const HostGl &host) : host_(host) {}

    // Changes all state that claque sets for its picture: switches, functions, masks, matrices and their stacks,
    // arrays, textures, unpacking. State that claque inherits from its host gets values that change no picture.
    void with_what_claque_sets();

    // The same, and all state that claque inherits: lights, fog, clip planes, stencil, scissor, viewport, polygon mode
    // ...
    void with_everything();

private:
    void leave_stacks_deep() const;
    void spoil_the_bound_texture() const;

    const HostGl &host_;
    std::vector<std::unique_ptr<HostileHost>> kept_;  // memory of the arrays that GL points to
};

}  // namespace gltest
