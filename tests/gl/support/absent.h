// When a test may skip for want of OpenGL: only where the loader does not find the libraries, which are named. A
// context that cannot be made although they are there is a failure.
#pragma once

#include <dlfcn.h>
#include <string>

#include <gtest/gtest.h>

#include "samples/contexts/offscreen.h"

namespace gltest
{

inline bool can_load(const char *library)
{
    void *handle = dlopen(library, RTLD_NOW | RTLD_LOCAL);
    if (handle) dlclose(handle);
    return handle != nullptr;
}

// The libraries that contexts of this kind lack here, or nothing.
inline std::string absent_gl(contexts::Kind kind)
{
    std::string absent;
    if (kind == contexts::Kind::any) kind = contexts::kind_of_environment();
    if (kind == contexts::Kind::glx)
        return can_load("libX11.so.6") && can_load("libGL.so.1") ? ""
                                                                 : "libX11.so.6 and libGL.so.1 are not both installed";
    if (kind != contexts::Kind::egl) {
        if (can_load("libOSMesa.so.8") || can_load("libOSMesa.so.6") || can_load("libOSMesa.so")) return "";
        absent = "libOSMesa.so.8 is not installed";
    }
    if (kind != contexts::Kind::osmesa) {
        if (can_load("libEGL.so.1") && can_load("libEGL_mesa.so.0")) return "";
        absent +=
            std::string(absent.empty() ? "" : ", and ") + "libEGL.so.1 and libEGL_mesa.so.0 are not both installed";
    }
    return absent;
}

}  // namespace gltest

// Ends a test that has no context: skips it if the libraries are absent, else fails it with `why`.
#define END_WITHOUT_CONTEXT(kind, why)                                                                   \
    do {                                                                                                 \
        if (const std::string absent = gltest::absent_gl(kind); !absent.empty()) GTEST_SKIP() << absent; \
        FAIL() << "no OpenGL context, although its libraries are installed: " << (why);                  \
    } while (false)
