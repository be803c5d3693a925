// GLX with a pixel buffer: needs an X server, but no window. LIBGL_ALWAYS_INDIRECT makes Mesa send every call of GL to
// the server.
#include "samples/contexts/backends.h"

namespace contexts
{
namespace
{

using Id = unsigned long;  // of an X resource
// GLX's names of what a configuration and a surface have.
struct Glx {
    static constexpr int drawable_type = 0x8010, pbuffer_bit = 4, render_type = 0x8011, rgba_bit = 1;
    static constexpr int rgba_type = 0x8014, width_key = 0x8041, height_key = 0x8040;
    static constexpr int red = 8, green = 9, blue = 10, alpha = 11, depth = 12, stencil = 13, samples = 100001,
                         doublebuffer = 5;
};

struct GlxLibrary {
    int (*init_threads)() = nullptr;
    Handle (*open_display)(const char *) = nullptr;
    int (*free)(void *) = nullptr;
    GlFunction (*get_proc_address)(const char *) = nullptr;
    Handle *(*choose_config)(Handle display, int screen, const int *wanted, int *count) = nullptr;
    int (*get_config)(Handle display, Handle config, int what, int *value) = nullptr;
    Handle (*create_context)(Handle display, Handle config, int type, Handle share, int direct) = nullptr;
    Id (*create_surface)(Handle display, Handle config, const int *attributes) = nullptr;
    int (*make_current)(Handle display, Id draw, Id read, Handle context) = nullptr;
    int (*is_direct)(Handle display, Handle context) = nullptr;
    void (*destroy_context)(Handle display, Handle context) = nullptr;
    void (*destroy_surface)(Handle display, Id surface) = nullptr;
    Handle display = nullptr;
    const char *why_not = nullptr;
};

GlxLibrary open_glx()
{
    static const char *const x11_names[] = {"libX11.so.6", nullptr}, *const gl_names[] = {"libGL.so.1", nullptr};
    GlxLibrary l;
    l.why_not = "GLX: libX11.so.6 or libGL.so.1 is missing (Debian: libx11-6 and libgl1)";
    Handle x11 = open_library(x11_names), so = open_library(gl_names);
    if (!x11 || !so || !find(x11, "XInitThreads", l.init_threads) || !find(x11, "XOpenDisplay", l.open_display) ||
        !find(x11, "XFree", l.free) || !find(so, "glXGetProcAddressARB", l.get_proc_address) ||
        !find(so, "glXChooseFBConfig", l.choose_config) || !find(so, "glXGetFBConfigAttrib", l.get_config) ||
        !find(so, "glXCreateNewContext", l.create_context) || !find(so, "glXCreatePbuffer", l.create_surface) ||
        !find(so, "glXMakeContextCurrent", l.make_current) || !find(so, "glXIsDirect", l.is_direct) ||
        !find(so, "glXDestroyContext", l.destroy_context) || !find(so, "glXDestroyPbuffer", l.destroy_surface))
        return l;
    l.why_not = "GLX: no X server answers; the variable DISPLAY names it";
    l.init_threads();
    l.display = l.open_display(nullptr);
    if (l.display) l.why_not = nullptr;
    return l;
}

// Opened once and kept with its display.
const GlxLibrary &glx_library()
{
    static const GlxLibrary opened = open_glx();
    return opened;
}

int glx_value(Handle config, int what)
{
    int value = -1;
    glx_library().get_config(glx_library().display, config, what, &value);
    return value;
}

// GLX sorts deeper colours first, so the exact format has to be searched for. Two buffers, because Mesa would send the
// only one to the server, which refuses it for a pixel buffer of another depth than the screen's.
Handle choose_glx_config(PixelFormat format)
{
    const GlxLibrary &l = glx_library();
    const bool small = format == PixelFormat::rgb565;
    const int wanted[] = {
        Glx::drawable_type, Glx::pbuffer_bit, Glx::render_type, Glx::rgba_bit, Glx::doublebuffer, 1, Glx::depth, 24, 0};
    int count = 0;
    Handle *configs = l.choose_config(l.display, 0, wanted, &count), found = nullptr;
    for (int i = 0; configs && i < count && !found; ++i)
        if (glx_value(configs[i], Glx::red) == (small ? 5 : 8) &&
            glx_value(configs[i], Glx::green) == (small ? 6 : 8) &&
            glx_value(configs[i], Glx::blue) == (small ? 5 : 8) &&
            glx_value(configs[i], Glx::alpha) == (small ? 0 : 8) && glx_value(configs[i], Glx::samples) == 0 &&
            glx_value(configs[i], Glx::depth) == 24 && glx_value(configs[i], Glx::stencil) == 8)
            found = configs[i];
    if (configs) l.free(configs);
    return found;
}

class GlxOffscreen : public Offscreen
{
public:
    GlxOffscreen(int width, int height) : Offscreen(width, height) {}
    ~GlxOffscreen() override
    {
        const GlxLibrary &l = glx_library();
        if (context_ && current() == this) release();
        if (context_) l.destroy_context(l.display, context_);
        if (surface_) l.destroy_surface(l.display, surface_);
    }

    bool start(PixelFormat format, std::string &why_not)
    {
        const GlxLibrary &l = glx_library();
        Handle config = choose_glx_config(format);
        if (!config) {
            why_not = "GLX: no pixel buffer with OpenGL in this format";
            return false;
        }
        const int size[] = {Glx::width_key, width(), Glx::height_key, height(), 0};
        surface_ = l.create_surface(l.display, config, size);
        context_ = l.create_context(l.display, config, Glx::rgba_type, nullptr, 1);
        if (!surface_ || !context_ || !make_current()) {
            why_not = "GLX: no OpenGL context of this size could be made";
            return false;
        }
        return describe(l.is_direct(l.display, context_) ? "GLX" : "GLX indirect", why_not);
    }
    bool make_current() override
    {
        current() = this;
        return glx_library().make_current(glx_library().display, surface_, surface_, context_) != 0;
    }
    bool release() override
    {
        current() = nullptr;
        return glx_library().make_current(glx_library().display, 0, 0, nullptr) != 0;
    }
    GetProcAddress get_proc_address() const override
    {
        return [](void *, const char *name) { return glx_library().get_proc_address(name); };
    }
    void *user() const override { return nullptr; }
    bool flushes_cheaply() const override { return true; }

private:
    static GlxOffscreen *&current()
    {
        static thread_local GlxOffscreen *made_current = nullptr;
        return made_current;
    }

    Id surface_ = 0;
    Handle context_ = nullptr;
};

}  // namespace

std::unique_ptr<Offscreen> make_glx(int width, int height, PixelFormat format, std::string &why_not)
{
    if (glx_library().why_not) {
        why_not = glx_library().why_not;
        return nullptr;
    }
    auto made = std::make_unique<GlxOffscreen>(width, height);
    if (!made->start(format, why_not)) return nullptr;
    return made;
}

}  // namespace contexts
