#include "samples/view/serve/vnc.h"

#include <dlfcn.h>

#include "samples/scenes/check.h"

namespace view::serve
{

const Vnc &vnc()
{
    static const Vnc opened = [] {
        void *library = dlopen("libvncserver.so.1", RTLD_NOW | RTLD_LOCAL);
        if (!library) throw scenes::Failure("--serve needs libvncserver.so.1 (Debian: libvncserver1)");
        Vnc functions;
#define CLAQUE_VIEW_VNC_FIND(name)                                                      \
    functions.name = reinterpret_cast<decltype(functions.name)>(dlsym(library, #name)); \
    if (!functions.name) throw scenes::Failure("libvncserver.so.1 lacks " #name);
        CLAQUE_VIEW_VNC(CLAQUE_VIEW_VNC_FIND)
#undef CLAQUE_VIEW_VNC_FIND
        functions.rfbLogEnable(0);
        return functions;
    }();
    return opened;
}

}  // namespace view::serve
