/* Draws a crowd into a corner of any program that shows OpenGL 1.x by GLX, without a change to the program:
 *
 *   LD_PRELOAD=build/release/samples/libclaque-guest.so glxgears
 *
 * The linker finds the functions below before those of libGL. The program may also ask for glXSwapBuffers by name, so
 * the three functions that answer such questions are here as well. */
#include <dlfcn.h>
#include <stddef.h>
#include <string.h>

#include "samples/guest/corner.h"

#define SHOWN __attribute__((visibility("default")))

typedef void *(*find_function)(void *library, const char *name);

SHOWN void *dlsym(void *library, const char *name);
SHOWN clq_gl_function glXGetProcAddress(const unsigned char *name);
SHOWN clq_gl_function glXGetProcAddressARB(const unsigned char *name);
SHOWN void glXSwapBuffers(void *display, unsigned long drawable);

/* The C library's dlsym; its version differs with the C library and the processor. */
static find_function real_dlsym(void)
{
    static const char *const versions[] = {"GLIBC_2.34", "GLIBC_2.17", "GLIBC_2.2.5", "GLIBC_2.0"};
    static find_function found;
    for (size_t i = 0; !found && i < sizeof versions / sizeof *versions; ++i)
        *(void **)&found = dlvsym(RTLD_NEXT, "dlsym", versions[i]);
    return found;
}

/* The function that the program would have got: of a library preloaded after this one, or of libGL. */
static clq_gl_function next(const char *name)
{
    void *found = real_dlsym()(RTLD_NEXT, name);
    clq_gl_function function;
    if (!found) found = real_dlsym()(dlopen("libGL.so.1", RTLD_LAZY), name);
    memcpy(&function, &found, sizeof function);
    return function;
}

static clq_gl_function ours(const char *name)
{
    if (!strcmp(name, "glXSwapBuffers")) return (clq_gl_function)glXSwapBuffers;
    if (!strcmp(name, "glXGetProcAddress")) return (clq_gl_function)glXGetProcAddress;
    if (!strcmp(name, "glXGetProcAddressARB")) return (clq_gl_function)glXGetProcAddressARB;
    return NULL;
}

static clq_gl_function get_proc_address(void *user, const char *name)
{
    static clq_gl_function (*find)(const unsigned char *);
    (void)user;
    if (!find) find = (clq_gl_function(*)(const unsigned char *))next("glXGetProcAddressARB");
    return find((const unsigned char *)name);
}

/* RTLD_NEXT is relative to the caller: the last line has to be a jump, as it is in an optimised build. */
void *dlsym(void *library, const char *name)
{
    void *found;
    const clq_gl_function mine = ours(name);
    memcpy(&found, &mine, sizeof found);
    if (found) return found;
    return real_dlsym()(library, name);
}

clq_gl_function glXGetProcAddressARB(const unsigned char *name)
{
    const clq_gl_function mine = ours((const char *)name);
    return mine ? mine : get_proc_address(NULL, (const char *)name);
}

clq_gl_function glXGetProcAddress(const unsigned char *name) { return glXGetProcAddressARB(name); }

void glXSwapBuffers(void *display, unsigned long drawable)
{
    static void (*swap)(void *, unsigned long);
    static void *(*current)(void);
    if (!swap) {
        swap = (void (*)(void *, unsigned long))next("glXSwapBuffers");
        current = (void *(*)(void))next("glXGetCurrentContext");
    }
    const void *const context = current();
    if (context) corner_draw(context, get_proc_address);
    swap(display, drawable);
}
