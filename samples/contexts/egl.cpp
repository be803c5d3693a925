// EGL on the surfaceless platform or a device, drawing into a pixel buffer surface: no window system is needed.
#include "samples/contexts/egl_library.h"

namespace contexts
{
namespace
{

constexpr unsigned opengl_api = 0x30A2;
constexpr int surface_type = 0x3033, pbuffer_bit = 1, renderable_type = 0x3040, opengl_bit = 8, end = 0x3038;
constexpr int alpha_size = 0x3021, blue_size = 0x3022, green_size = 0x3023, red_size = 0x3024;
constexpr int depth_size = 0x3025, stencil_size = 0x3026, sample_count = 0x3031, width_key = 0x3057,
              height_key = 0x3056;

int config_value(Handle config, int what)
{
    int value = -1;
    egl_library().get_config(egl_library().display, config, what, &value);
    return value;
}

// EGL sorts deeper colours first, so the exact format has to be searched for.
Handle choose_config(PixelFormat format)
{
    const bool small = format == PixelFormat::rgb565;
    const int wanted[] = {surface_type, pbuffer_bit, renderable_type, opengl_bit, depth_size, 24, end};
    Handle configs[256];
    int count = 0;
    if (!egl_library().choose_config(egl_library().display, wanted, configs, 256, &count)) return nullptr;
    for (int i = 0; i < count; ++i)
        if (config_value(configs[i], red_size) == (small ? 5 : 8) &&
            config_value(configs[i], green_size) == (small ? 6 : 8) &&
            config_value(configs[i], blue_size) == (small ? 5 : 8) &&
            config_value(configs[i], alpha_size) == (small ? 0 : 8) && config_value(configs[i], sample_count) == 0 &&
            config_value(configs[i], depth_size) == 24 && config_value(configs[i], stencil_size) == 8)
            return configs[i];
    return nullptr;
}

class EglOffscreen : public Offscreen
{
public:
    EglOffscreen(int width, int height) : Offscreen(width, height) {}
    ~EglOffscreen() override
    {
        const EglLibrary &l = egl_library();
        if (context_ && current() == this) release();
        if (context_) l.destroy_context(l.display, context_);
        if (surface_) l.destroy_surface(l.display, surface_);
    }

    bool start(PixelFormat format, std::string &why_not)
    {
        const EglLibrary &l = egl_library();
        Handle config = l.bind_api(opengl_api) ? choose_config(format) : nullptr;
        if (!config) {
            why_not = "EGL: no pixel buffer with desktop OpenGL in this format";
            return false;
        }
        const int size[] = {width_key, width(), height_key, height(), end};
        surface_ = l.create_surface(l.display, config, size);
        context_ = l.create_context(l.display, config, nullptr, nullptr);
        if (!surface_ || !context_ || !make_current()) {
            why_not = "EGL: no OpenGL context of this size could be made";
            return false;
        }
        return describe("EGL", why_not);
    }
    // Releases the context first: EGL would believe it still current after OSMesa took over Mesa's dispatch.
    bool make_current() override
    {
        const EglLibrary &l = egl_library();
        l.bind_api(opengl_api);
        release();
        current() = this;
        return l.make_current(l.display, surface_, surface_, context_) != 0;
    }
    bool release() override
    {
        current() = nullptr;
        return egl_library().make_current(egl_library().display, nullptr, nullptr, nullptr) != 0;
    }
    GetProcAddress get_proc_address() const override
    {
        return
            [](void *, const char *name) { return reinterpret_cast<GlFunction>(egl_library().get_proc_address(name)); };
    }
    void *user() const override { return nullptr; }
    bool flushes_cheaply() const override { return true; }

private:
    static EglOffscreen *&current()
    {
        static thread_local EglOffscreen *made_current = nullptr;
        return made_current;
    }

    Handle surface_ = nullptr, context_ = nullptr;
};

}  // namespace

std::unique_ptr<Offscreen> make_egl(int width, int height, PixelFormat format, std::string &why_not)
{
    if (!egl_library().why_not.empty()) {
        why_not = egl_library().why_not;
        return nullptr;
    }
    auto made = std::make_unique<EglOffscreen>(width, height);
    if (!made->start(format, why_not)) return nullptr;
    return made;
}

}  // namespace contexts
