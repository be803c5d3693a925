// All state of GL 1.1 that a program can query, as text by name, so that two dumps can be compared.
#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include "tests/gl/support/host_gl.h"

namespace gltest
{

struct StateValue {
    gl::Enum name = 0;           // the GL name of the query; for lights the light's own
    std::vector<double> values;  // bits of pointers and patterns as numbers
};

using State = std::map<std::string, StateValue>;  // by a readable name, for example "GL_LIGHT0 GL_POSITION"

// State of the current context. Texture parameters are those of the bound textures.
State dump_state(const HostGl &host, bool has_multisample = true);

// Readable names of the differences.
std::vector<std::string> differences(const State &before, const State &after);

std::string text_of(const StateValue &value);

}  // namespace gltest
