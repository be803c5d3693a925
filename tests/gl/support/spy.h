// A GL between claque and the real one: counts every call by name, and can refuse a function or answer a query in place
// of GL. Only one at a time.
#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "samples/contexts/offscreen.h"
#include "tests/gl/support/host_gl.h"

namespace gltest
{

class Spy
{
public:
    explicit Spy(const contexts::Offscreen &context);
    ~Spy();

    // The table that a renderer is opened with.
    static claque::passes::GlFunction get_proc_address(void *user, const char *name);
    void *user() { return this; }

    // Called before every GL call with its arguments as numbers, pointers too.
    std::function<void(const std::string &name, const std::vector<double> &arguments)> watch;
    std::string refuse;                       // this name resolves to null
    std::map<gl::Enum, int32_t> answers;      // values that glGetIntegerv returns in place of GL's
    std::map<gl::Enum, std::string> strings;  // likewise for glGetString
    bool forgets_vertex_array = false;        // glPopClientAttrib leaves it as it is
    bool forgets_samples = false;             // glPopAttrib leaves GL_MULTISAMPLE and its like as they are

    std::vector<std::string> asked;         // loaded names in order
    std::map<std::string, uint32_t> calls;  // since reset()
    uint32_t call_count() const;
    void reset() { calls.clear(); }
    void note(const char *name, const std::vector<double> &arguments);

private:
    const contexts::Offscreen &context_;
};

}  // namespace gltest
