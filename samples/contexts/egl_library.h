// The EGL library of this machine and a display of it that needs no window system; private to this folder.
#pragma once

#include <string>

#include "samples/contexts/backends.h"

namespace contexts
{

struct EglLibrary {
    Handle (*get_proc_address)(const char *) = nullptr;
    unsigned (*initialize)(Handle display, int *major, int *minor) = nullptr;
    unsigned (*bind_api)(unsigned api) = nullptr;
    unsigned (*choose_config)(Handle display, const int *wanted, Handle *configs, int capacity, int *count) = nullptr;
    unsigned (*get_config)(Handle display, Handle config, int what, int *value) = nullptr;
    Handle (*create_context)(Handle display, Handle config, Handle share, const int *attributes) = nullptr;
    Handle (*create_surface)(Handle display, Handle config, const int *attributes) = nullptr;
    unsigned (*make_current)(Handle display, Handle draw, Handle read, Handle context) = nullptr;
    unsigned (*destroy_context)(Handle display, Handle context) = nullptr;
    unsigned (*destroy_surface)(Handle display, Handle surface) = nullptr;
    Handle display = nullptr;
    std::string why_not;  // empty where there is a display
};

// Opened once and kept with its display, because other code in the process may share it. The display is Mesa's
// surfaceless platform, and without it the first device. The environment variable CLAQUE_EGL_DEVICE names another
// device by its number, counted from 0: for example a graphics card whose driver has no surfaceless platform.
const EglLibrary &egl_library();

}  // namespace contexts
