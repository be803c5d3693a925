// When a test may skip for want of an extension: only where GL's own list, read whole, does not name it. Mesa has those
// that tests ask for, unless its environment limits them: there, one that is not found is a failure.
#pragma once

#include <cstdlib>
#include <sstream>
#include <string>

#include <gtest/gtest.h>

#include "tests/gl/support/host_gl.h"

namespace gltest
{

struct AskedExtension {
    bool is_there = false, may_be_absent = false;
    std::string why;
};

// list, version: what GL says of itself; null where it says nothing.
inline AskedExtension find_extension(const std::string &name, const char *list, const char *version, bool is_limited)
{
    AskedExtension out;
    if (!list || !version) {
        out.why = "GL does not say which extensions it has";
        return out;
    }
    std::istringstream words(list);
    for (std::string word; words >> word;) out.is_there = out.is_there || word == name;
    if (out.is_there) return out;
    out.may_be_absent = is_limited || std::string(version).find("Mesa") == std::string::npos;
    out.why = std::string("GL ") + version + " does not name " + name;
    return out;
}

inline AskedExtension find_extension(const std::string &name, const HostGl &host)
{
    const auto text = [&](gl::Enum what) { return reinterpret_cast<const char *>(host.GetString(what)); };
    const bool is_limited = std::getenv("MESA_EXTENSION_MAX_YEAR") || std::getenv("MESA_EXTENSION_OVERRIDE");
    return find_extension(name, text(gl::extensions), text(gl::version), is_limited);
}

}  // namespace gltest

// Ends a test that needs an extension which is not there.
#define NEEDS_EXTENSION(name, host)                                              \
    do {                                                                         \
        const gltest::AskedExtension asked = gltest::find_extension(name, host); \
        if (!asked.is_there && asked.may_be_absent) GTEST_SKIP() << asked.why;   \
        if (!asked.is_there) FAIL() << asked.why;                                \
    } while (false)
