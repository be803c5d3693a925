// A GL between claque and the real one: counts every call by name, and can refuse a function, or answer a query, in its
// place. One at a time.
#pragma once

#include "samples/contexts/offscreen.h"
#include "tests/gl/support/host_gl.h"

#include <functional>
#include <map>
#include <string>
#include <vector>

namespace gltest
{

class Spy
{
public:
    explicit Spy(const contexts::Offscreen &context);
    ~Spy();

    // What a renderer is opened with.
    static claque::passes::GlFunction get_proc_address(void *user, const char *name);
    void *user() { return this; }

    // Told of every call before it is made, with its arguments as numbers, pointers too.
    std::function<void(const std::string &name, const std::vector<double> &arguments)> watch;
    std::string refuse;                       // this name is answered with null
    std::map<gl::Enum, int32_t> answers;      // glGetIntegerv says this instead
    std::map<gl::Enum, std::string> strings;  // glGetString likewise

    std::vector<std::string> asked;         // names in order
    std::map<std::string, uint32_t> calls;  // since reset()
    uint32_t call_count() const;
    void reset() { calls.clear(); }
    void note(const char *name, const std::vector<double> &arguments);

private:
    const contexts::Offscreen &context_;
};

}  // namespace gltest
