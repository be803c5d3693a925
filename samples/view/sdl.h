// The functions of SDL2 that a window needs. The library is opened when a window is, so that the claque command needs
// none on machines without a screen.
#pragma once

#include <string>

#define SDL_MAIN_HANDLED
#include <SDL2/SDL.h>

namespace view
{

#define CLAQUE_VIEW_SDL(FUNCTION)                                                                          \
    FUNCTION(Init)                                                                                         \
    FUNCTION(Quit)                                                                                         \
    FUNCTION(GetError)                                                                                     \
    FUNCTION(SetMainReady)                                                                                 \
    FUNCTION(GetCurrentVideoDriver)                                                                        \
    FUNCTION(CreateWindow)                                                                                 \
    FUNCTION(DestroyWindow)                                                                                \
    FUNCTION(PollEvent)                                                                                    \
    FUNCTION(SetWindowMinimumSize)                                                                         \
    FUNCTION(GL_SetAttribute)                                                                              \
    FUNCTION(GL_CreateContext)                                                                             \
    FUNCTION(GL_DeleteContext)                                                                             \
    FUNCTION(GL_SwapWindow)                                                                                \
    FUNCTION(GL_SetSwapInterval)                                                                           \
    FUNCTION(GL_GetProcAddress) FUNCTION(GL_GetDrawableSize) FUNCTION(GetWindowSize) FUNCTION(GetModState) \
        FUNCTION(StartTextInput) FUNCTION(free)

struct Sdl {
#define CLAQUE_VIEW_SDL_MEMBER(name) decltype(&SDL_##name) name = nullptr;
    CLAQUE_VIEW_SDL(CLAQUE_VIEW_SDL_MEMBER)
#undef CLAQUE_VIEW_SDL_MEMBER
};

// Opened once for the process. Throws scenes::Failure.
const Sdl &sdl();

}  // namespace view
