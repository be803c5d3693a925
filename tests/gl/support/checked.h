// Checks every call that passes a Spy against the first version of GL 1.1: its enums, the stack depths that every
// implementation has, textures of powers of two.
#pragma once

#include <set>

#include "tests/gl/support/spy.h"

namespace gltest
{

// The enums of GL 1.1, from the system's own header above its first line about 1.2; empty if the header is missing.
const std::set<uint32_t> &values_of_gl_1_1();

class Checked
{
public:
    // Makes the spy answer as GL 1.1 without extensions would, and watches it.
    explicit Checked(Spy &spy);

    std::vector<std::string> offences;  // each once
    size_t calls = 0;

private:
    void check(const std::string &name, const std::vector<double> &arguments);
    void check_values(const std::string &name, const std::vector<double> &arguments);
    void check_stacks(const std::string &name, const std::vector<double> &arguments);
    void check_texture(const std::vector<double> &arguments);
    void check_drawing(const std::string &name, const std::vector<double> &arguments);
    void offend(const std::string &what);

    std::map<uint32_t, int> depths_;  // by matrix mode
    uint32_t mode_ = gl::modelview;
    int attributes_ = 0, client_ = 0;
};

}  // namespace gltest
