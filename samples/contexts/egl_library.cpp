#include "samples/contexts/egl_library.h"

#include <cstdlib>

namespace contexts
{
namespace
{

constexpr unsigned platform_surfaceless = 0x31DD, platform_device = 0x313F;
constexpr int most_devices = 64;

using GetPlatformDisplay = Handle (*)(unsigned platform, Handle native, const int *attributes);
using QueryDevices = unsigned (*)(int capacity, Handle *devices, int *count);

bool find_functions(EglLibrary &l)
{
    static const char *const names[] = {"libEGL.so.1", "libEGL.so", nullptr};
    Handle so = open_library(names);
    return so && find(so, "eglGetProcAddress", l.get_proc_address) && find(so, "eglInitialize", l.initialize) &&
           find(so, "eglBindAPI", l.bind_api) && find(so, "eglChooseConfig", l.choose_config) &&
           find(so, "eglGetConfigAttrib", l.get_config) && find(so, "eglCreateContext", l.create_context) &&
           find(so, "eglCreatePbufferSurface", l.create_surface) && find(so, "eglMakeCurrent", l.make_current) &&
           find(so, "eglDestroyContext", l.destroy_context) && find(so, "eglDestroySurface", l.destroy_surface);
}

bool open_platform(EglLibrary &l, unsigned platform, Handle native)
{
    const auto get = reinterpret_cast<GetPlatformDisplay>(l.get_proc_address("eglGetPlatformDisplayEXT"));
    int major = 0, minor = 0;
    l.display = get ? get(platform, native, nullptr) : nullptr;
    if (l.display && l.initialize(l.display, &major, &minor)) return true;
    l.display = nullptr;
    return false;
}

int list_devices(const EglLibrary &l, Handle (&devices)[most_devices])
{
    const auto query = reinterpret_cast<QueryDevices>(l.get_proc_address("eglQueryDevicesEXT"));
    int count = 0;
    return query && query(most_devices, devices, &count) ? count : 0;
}

void open_device(EglLibrary &l, const std::string &wanted)
{
    Handle devices[most_devices];
    const int count = list_devices(l, devices);
    char *end = nullptr;
    const long number = std::strtol(wanted.c_str(), &end, 10);
    if (end == wanted.c_str() || *end != '\0' || number < 0 || number >= count) {
        l.why_not = "EGL: CLAQUE_EGL_DEVICE is '" + wanted + "', and this machine has " + std::to_string(count) +
                    (count == 1 ? " device" : " devices") + ", counted from 0";
        return;
    }
    if (!open_platform(l, platform_device, devices[number]))
        l.why_not = "EGL: device " + wanted + " of CLAQUE_EGL_DEVICE does not start";
}

EglLibrary open_display()
{
    EglLibrary l;
    if (!find_functions(l)) {
        l.why_not = "EGL: libEGL.so.1 is missing (Debian: libegl1 and libgl1-mesa-dri)";
        return l;
    }
    const std::string wanted = environment("CLAQUE_EGL_DEVICE"), driver = environment("GALLIUM_DRIVER");
    if (!wanted.empty()) {
        open_device(l, wanted);
        return l;
    }
    if (open_platform(l, platform_surfaceless, nullptr)) return l;
    Handle devices[most_devices];
    const int count = list_devices(l, devices);
    for (int i = 0; i < count; ++i)
        if (open_platform(l, platform_device, devices[i])) return l;
    l.why_not = driver.empty() ? "EGL: no surfaceless platform and no device (Debian: libgl1-mesa-dri)"
                               : "EGL: no driver starts with GALLIUM_DRIVER '" + driver +
                                     "' (Mesa has llvmpipe and softpipe: Debian's libgl1-mesa-dri)";
    return l;
}

}  // namespace

const EglLibrary &egl_library()
{
    static const EglLibrary opened = open_display();
    return opened;
}

}  // namespace contexts
