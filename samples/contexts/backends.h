// Declarations that the kinds of context share; private to this folder.
#pragma once

#include "samples/contexts/offscreen.h"

namespace contexts
{

using Handle = void *;

std::unique_ptr<Offscreen> make_osmesa(int width, int height, PixelFormat format, std::string &why_not);
std::unique_ptr<Offscreen> make_egl(int width, int height, PixelFormat format, std::string &why_not);
std::unique_ptr<Offscreen> make_glx(int width, int height, PixelFormat format, std::string &why_not);

void tell_leak_checker();

// An environment variable, or nothing.
std::string environment(const char *name);

// Opens the first library of a null-terminated list and keeps it for the life of the process, because drivers do not
// tolerate unloading. Null if there is none.
void *open_library(const char *const *names);

// A function of an opened library, or null.
template <class Function>
bool find(void *library, const char *name, Function &function);

void *find_symbol(void *library, const char *name);

// A function of a context, or null.
template <class Function>
Function ask(const Offscreen &context, const char *name)
{
    return reinterpret_cast<Function>(context.get_proc_address()(context.user(), name));
}

template <class Function>
bool find(void *library, const char *name, Function &function)
{
    function = reinterpret_cast<Function>(find_symbol(library, name));
    return function != nullptr;
}

}  // namespace contexts
