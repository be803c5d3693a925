// Hosts with random state: each piece of state that claque promises to cope with has any value that GL 1.1 allows.
// State that claque inherits is set too, to values that change no picture.
#pragma once

#include <cstdint>

#include "tests/gl/support/host_gl.h"

namespace gltest
{

// Every switch of GL 1.1 that glEnable knows, and its effect on a picture with default parameters.
struct Switch {
    gl::Enum name;
    bool inherited_and_seen;  // the host's own fog and lighting stay visible
};
extern const Switch all_switches[];
extern const size_t switch_count;

class TorturedHost
{
public:
    // The same state for the same number. The context's state must be at its default.
    TorturedHost(const HostGl &host, uint32_t number);

private:
    uint32_t random_below(uint32_t of);  // [0, of)
    bool coin() { return random_below(2) == 1; }
    gl::Enum one_of(std::initializer_list<gl::Enum> values)
    {
        return values.begin()[random_below(uint32_t(values.size()))];
    }
    float real() { return static_cast<float>(random_below(2001)) / 500 - 2; }  // [-2, 2]

    void set_switches();
    void set_functions();
    void set_colours();
    void set_texturing();
    void set_matrices();
    void set_arrays();
    void set_pixels();
    void fill_stacks();

    const HostGl &host_;
    uint64_t state_;
    float numbers_[256] = {0};
    uint32_t textures_[2] = {0, 0};
};

}  // namespace gltest
