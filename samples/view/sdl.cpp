#include "samples/view/sdl.h"

#include <dlfcn.h>

#include "samples/scenes/check.h"

namespace view
{

const Sdl &sdl()
{
    static const Sdl opened = [] {
        void *library = dlopen("libSDL2-2.0.so.0", RTLD_NOW | RTLD_LOCAL);
        if (!library) throw scenes::Failure("a window needs libSDL2-2.0.so.0 (Debian: libsdl2-2.0-0)");
        Sdl functions;
#define CLAQUE_VIEW_SDL_FIND(name)                                                             \
    functions.name = reinterpret_cast<decltype(functions.name)>(dlsym(library, "SDL_" #name)); \
    if (!functions.name) throw scenes::Failure("libSDL2-2.0.so.0 lacks SDL_" #name);
        CLAQUE_VIEW_SDL(CLAQUE_VIEW_SDL_FIND)
#undef CLAQUE_VIEW_SDL_FIND
        return functions;
    }();
    return opened;
}

}  // namespace view
