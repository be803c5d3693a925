/* A GL context of software without a window, for the examples: OSMesa where it is, else EGL's surfaceless platform. A
 * program of your own has a context already; samples/contexts has more kinds of them. */
#ifndef CLAQUE_EXAMPLES_OFFSCREEN_H
#define CLAQUE_EXAMPLES_OFFSCREEN_H

#include <claque/renderer.h>

#include <dlfcn.h>
#include <stdint.h>
#include <stdio.h>

enum { OFFSCREEN_RGBA = 0x1908, OFFSCREEN_UNSIGNED_BYTE = 0x1401 };

typedef struct offscreen {
    void *display, *surface, *context; /* OSMesa has a context alone */
    int width, height;
    unsigned char *rgba; /* the caller's, bottom row first */
} offscreen;

/* Names of a library that was opened; others stay null. */
static struct {
    clq_gl_function (*get)(const char *name);
    void (*destroy_mesa)(void *context);
    unsigned (*make_current)(void *display, void *draw, void *read, void *context);
    unsigned (*destroy_context)(void *display, void *context), (*destroy_surface)(void *display, void *surface);
} offscreen_gl;

/* In the form of clq_renderer_def. */
static clq_gl_function offscreen_function(void *user, const char *name) { return (void)user, offscreen_gl.get(name); }

static bool offscreen_open_mesa(offscreen *made, void *library)
{
    void *(*create)(unsigned, int, int, int, void *);
    unsigned char (*make_current)(void *, void *, unsigned, int, int);
    *(void **)&create = dlsym(library, "OSMesaCreateContextExt");
    *(void **)&make_current = dlsym(library, "OSMesaMakeCurrent");
    *(void **)&offscreen_gl.destroy_mesa = dlsym(library, "OSMesaDestroyContext");
    *(void **)&offscreen_gl.get = dlsym(library, "OSMesaGetProcAddress");
    made->context = create(OFFSCREEN_RGBA, 24, 8, 0, NULL);
    return made->context && make_current(made->context, made->rgba, OFFSCREEN_UNSIGNED_BYTE, made->width, made->height);
}

static bool offscreen_open_egl(offscreen *made, void *library)
{
    enum { SURFACELESS = 0x31DD, OPENGL = 0x30A2, WIDTH_KEY = 0x3057, HEIGHT_KEY = 0x3056, END = 0x3038 };
    /* a pixel buffer for desktop OpenGL with 8 bits of alpha, blue, green and red, 24 of depth */
    static const int wanted[] = {0x3033, 1, 0x3040, 8, 0x3021, 8, 0x3022, 8, 0x3023, 8, 0x3024, 8, 0x3025, 24, END};
    const int size[] = {WIDTH_KEY, made->width, HEIGHT_KEY, made->height, END};
    void *(*get_display)(unsigned, void *, const intptr_t *), *config;
    unsigned (*initialize)(void *, int *, int *), (*bind)(unsigned);
    unsigned (*choose)(void *, const int *, void **, int, int *);
    void *(*create_surface)(void *, void *, const int *), *(*create_context)(void *, void *, void *, const int *);
    int count = 0;
    *(void **)&offscreen_gl.get = dlsym(library, "eglGetProcAddress");
    *(void **)&get_display = dlsym(library, "eglGetPlatformDisplay");
    *(void **)&initialize = dlsym(library, "eglInitialize");
    *(void **)&bind = dlsym(library, "eglBindAPI");
    *(void **)&choose = dlsym(library, "eglChooseConfig");
    *(void **)&create_surface = dlsym(library, "eglCreatePbufferSurface");
    *(void **)&create_context = dlsym(library, "eglCreateContext");
    *(void **)&offscreen_gl.make_current = dlsym(library, "eglMakeCurrent");
    *(void **)&offscreen_gl.destroy_context = dlsym(library, "eglDestroyContext");
    *(void **)&offscreen_gl.destroy_surface = dlsym(library, "eglDestroySurface");
    made->display = get_display ? get_display(SURFACELESS, NULL, NULL) : NULL;
    if (!made->display || !initialize(made->display, NULL, NULL) || !bind(OPENGL)) return false;
    if (!choose(made->display, wanted, &config, 1, &count) || count < 1) return false;
    made->surface = create_surface(made->display, config, size);
    made->context = create_context(made->display, config, NULL, NULL);
    return made->surface && made->context &&
           offscreen_gl.make_current(made->display, made->surface, made->surface, made->context);
}

/* Makes a context and makes it current. Without one it says so, and returns the program's exit status: 77 where no
 * library is there, else 1. */
static int offscreen_open(offscreen *made, int width, int height, unsigned char *rgba)
{
    void *mesa = dlopen("libOSMesa.so.8", RTLD_NOW | RTLD_LOCAL), *egl = NULL;
    const offscreen empty = {NULL, NULL, NULL, width, height, rgba};
    *made = empty;
    if (!mesa) egl = dlopen("libEGL.so.1", RTLD_NOW | RTLD_LOCAL);
    if (mesa ? offscreen_open_mesa(made, mesa) : egl && offscreen_open_egl(made, egl)) return 0;
    fputs(mesa || egl ? "OpenGL makes no context.\n"
                      : "OpenGL is missing (Debian: libosmesa6, or libegl1 and libgl1-mesa-dri).\n",
          stderr);
    return mesa || egl ? 1 : 77;
}

/* Waits until all is drawn, in `rgba`. */
static void offscreen_finish(offscreen *made)
{
    if (!made->display) offscreen_gl.get("glFinish")();
    else
        ((void (*)(int, int, int, int, unsigned, unsigned, void *))offscreen_gl.get("glReadPixels"))(
            0, 0, made->width, made->height, OFFSCREEN_RGBA, OFFSCREEN_UNSIGNED_BYTE, made->rgba);
}

static void offscreen_close(offscreen *made)
{
    if (!made->display) {
        offscreen_gl.destroy_mesa(made->context);
        return;
    }
    offscreen_gl.make_current(made->display, NULL, NULL, NULL);
    offscreen_gl.destroy_context(made->display, made->context);
    offscreen_gl.destroy_surface(made->display, made->surface);
}

#endif
