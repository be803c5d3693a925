// OSMesa: Mesa drawing into the program's own memory. Mesa dropped it in 25.1, which is why EGL is the other kind.
#include "samples/contexts/backends.h"

namespace contexts
{
namespace
{

constexpr unsigned osmesa_rgba = 0x1908, osmesa_rgb_565 = 0x5;
constexpr unsigned buffer_unsigned_byte = 0x1401, gl_unsigned_short_5_6_5 = 0x8363;

struct OsmesaContext;
struct OsmesaLibrary {
    OsmesaContext *(*create)(unsigned format, int depth_bits, int stencil_bits, int accumulation_bits,
                             OsmesaContext *share) = nullptr;
    void (*destroy)(OsmesaContext *) = nullptr;
    unsigned char (*make_current)(OsmesaContext *, void *buffer, unsigned type, int width, int height) = nullptr;
    GlFunction (*get_proc_address)(const char *name) = nullptr;
    OsmesaContext *(*current)() = nullptr;
    bool complete = false;
};

const OsmesaLibrary &osmesa_library()
{
    static const OsmesaLibrary opened = [] {
        static const char *const names[] = {"libOSMesa.so.8", "libOSMesa.so.6", "libOSMesa.so", nullptr};
        OsmesaLibrary l;
        if (void *handle = open_library(names))
            l.complete = find(handle, "OSMesaCreateContextExt", l.create) &&
                         find(handle, "OSMesaDestroyContext", l.destroy) &&
                         find(handle, "OSMesaMakeCurrent", l.make_current) &&
                         find(handle, "OSMesaGetProcAddress", l.get_proc_address) &&
                         find(handle, "OSMesaGetCurrentContext", l.current);
        return l;
    }();
    return opened;
}

class OsmesaOffscreen : public Offscreen
{
public:
    OsmesaOffscreen(int width, int height, PixelFormat format)
        : Offscreen(width, height),
          type_(format == PixelFormat::rgb565 ? gl_unsigned_short_5_6_5 : buffer_unsigned_byte),
          pixels_((format == PixelFormat::rgb565 ? 2 : 4) * static_cast<size_t>(width) * static_cast<size_t>(height)),
          context_(
              osmesa_library().create(format == PixelFormat::rgb565 ? osmesa_rgb_565 : osmesa_rgba, 24, 8, 0, nullptr))
    {
    }
    ~OsmesaOffscreen() override
    {
        if (!context_) return;
        if (osmesa_library().current() == context_) release();
        osmesa_library().destroy(context_);
    }

    bool start(std::string &why_not)
    {
        if (context_ && make_current()) return describe("OSMesa", why_not);
        why_not = "OSMesa: no context of this size and format could be made";
        return false;
    }
    bool make_current() override
    {
        return osmesa_library().make_current(context_, pixels_.data(), type_, width(), height()) != 0;
    }
    bool release() override { return osmesa_library().make_current(nullptr, nullptr, buffer_unsigned_byte, 0, 0) != 0; }
    GetProcAddress get_proc_address() const override
    {
        return [](void *, const char *name) { return osmesa_library().get_proc_address(name); };
    }
    void *user() const override { return nullptr; }
    bool flushes_cheaply() const override { return false; }

private:
    unsigned type_;
    std::vector<unsigned char> pixels_;
    OsmesaContext *context_;
};

}  // namespace

std::unique_ptr<Offscreen> make_osmesa(int width, int height, PixelFormat format, std::string &why_not)
{
    if (!osmesa_library().complete) {
        why_not =
            "OSMesa: libOSMesa.so.8 is missing (libosmesa6 of Debian 12 and 13; EGL serves too: libegl1 and "
            "libgl1-mesa-dri)";
        return nullptr;
    }
    // Mesa crashes where it cannot make a context for want of its driver.
    const std::string driver = environment("GALLIUM_DRIVER");
    if (!driver.empty() && driver != "llvmpipe" && driver != "softpipe") {
        why_not = "OSMesa: GALLIUM_DRIVER is '" + driver + "', and OSMesa has llvmpipe and softpipe";
        return nullptr;
    }
    auto made = std::make_unique<OsmesaOffscreen>(width, height, format);
    if (!made->start(why_not)) return nullptr;
    return made;
}

}  // namespace contexts
