// Preloaded after the guest (samples/guest), it writes down what a frame shows just before it is shown, and which state
// a draw of claque leaves changed. Preloaded alone, it writes the same of a program without a guest.
//
//   CLAQUE_WITNESS         the file that it writes: "frame NUMBER OUTSIDE CORNER", hashes of the pixels outside the
//                          guest's corner and in it; "left GUARD NAME", once for each name, with the mode of guard.h
//                          that documents it. FILE.ppm beside it is a late frame
//   CLAQUE_WITNESS_FRAMES  after so many frames the program ends
//   CLAQUE_GUEST           the corner, as for the guest
#include <cstdio>
#include <cstdlib>
#include <dlfcn.h>
#include <memory>
#include <set>
#include <unistd.h>

#include "passes/guard.h"
#include "samples/guest/corner.h"
#include "tests/gl/support/state_dump.h"

namespace
{

using contexts::GlFunction;

// Of samples/guest/preload.c.
extern "C" GlFunction glXGetProcAddressARB(const unsigned char *name);

GlFunction find_function(void *, const char *name)
{
    return glXGetProcAddressARB(reinterpret_cast<const unsigned char *>(name));
}

// The context that is current in a program, with the size of the drawable that it draws to.
class Shown : public contexts::Offscreen
{
public:
    Shown(int width, int height) : Offscreen(width, height) {}
    bool make_current() override { return true; }
    bool release() override { return false; }
    GetProcAddress get_proc_address() const override { return find_function; }
    void *user() const override { return nullptr; }
    bool flushes_cheaply() const override { return true; }
};

template <class Function>
Function ask(const char *name)
{
    return reinterpret_cast<Function>(find_function(nullptr, name));
}

int drawable_size(int what)
{
    unsigned size = 0;
    ask<void (*)(void *, unsigned long, int, unsigned *)>("glXQueryDrawable")(
        ask<void *(*)()>("glXGetCurrentDisplay")(), ask<unsigned long (*)()>("glXGetCurrentDrawable")(), what, &size);
    return int(size);
}

std::unique_ptr<Shown> shown()
{
    constexpr int glx_width = 0x801D, glx_height = 0x801E;
    return std::make_unique<Shown>(drawable_size(glx_width), drawable_size(glx_height));
}

std::FILE *report()
{
    static std::FILE *const file = [] {
        const char *path = std::getenv("CLAQUE_WITNESS");
        return path ? std::fopen(path, "w") : nullptr;
    }();
    if (!file) std::abort();
    return file;
}

// For people to look at.
void write_picture(const Shown &context, const std::vector<uint8_t> &rgb)
{
    std::FILE *const file = std::fopen((std::string(std::getenv("CLAQUE_WITNESS")) + ".ppm").c_str(), "wb");
    if (!file) return;
    std::fprintf(file, "P6 %d %d 255\n", context.width(), context.height());
    std::fwrite(rgb.data(), 1, rgb.size(), file);
    std::fclose(file);
}

// FNV-1a.
struct Hash {
    void add(uint8_t byte) { value = (value ^ byte) * 0x100000001b3; }
    uint64_t value = 0xcbf29ce484222325;
};

void write_frame(const Shown &context, int number)
{
    int wide = 320, high = 240;
    if (const char *corner = std::getenv("CLAQUE_GUEST")) std::sscanf(corner, "%dx%d", &wide, &high);
    std::vector<uint8_t> rgb;
    context.read_rgb(rgb);
    if (number % 50 == 49) write_picture(context, rgb);
    Hash outside, inside;
    for (int y = 0; y < context.height(); ++y)
        for (int x = 0; x < context.width(); ++x) {
            Hash &hash = x < wide && y >= context.height() - high ? inside : outside;
            for (size_t k = 0; k < 3; ++k) hash.add(rgb[3 * (size_t(y) * size_t(context.width()) + size_t(x)) + k]);
        }
    std::fprintf(report(), "frame %d %016llx %016llx\n", number, static_cast<unsigned long long>(outside.value),
                 static_cast<unsigned long long>(inside.value));
}

const char *documented_in(unsigned name)
{
    for (const auto &left : claque::passes::left_by_minimal)
        if (left.name == name) return "minimal";
    for (const auto &left : claque::passes::left_by_none)
        if (left.name == name) return "none";
    return "nowhere";
}

// Each name once; texture parameters belong to the bound texture, and a draw binds another one.
void write_left(const gltest::State &before, const gltest::State &after)
{
    static std::set<std::string> written;
    for (const std::string &name : gltest::differences(before, after))
        if (name.rfind("GL_TEXTURE_2D GL_", 0) != 0 && written.insert(name).second)
            std::fprintf(report(), "left %s %s\n", documented_in(after.at(name).name), name.c_str());
}

}  // namespace

// Called by glXSwapBuffers of samples/guest/preload.c, of which the witness has a copy of its own.
void corner_draw(const void *, clq_gl_function (*)(void *user, const char *name))
{
    static int number = 0;
    write_frame(*shown(), number++);
    const char *most = std::getenv("CLAQUE_WITNESS_FRAMES");
    if (!most || number < std::atoi(most)) return;
    std::fclose(report());
    _exit(0);
}

// The guest's call comes here.
extern "C" __attribute__((visibility("default"))) clq_status clq_renderer_draw(clq_renderer *renderer, clq_view *view,
                                                                               clq_draw_stats *out_stats)
{
    static const auto draw = reinterpret_cast<decltype(&clq_renderer_draw)>(dlsym(RTLD_NEXT, "clq_renderer_draw"));
    const gltest::HostGl host(*shown());
    const gltest::State before = gltest::dump_state(host);
    const clq_status status = draw(renderer, view, out_stats);
    write_left(before, gltest::dump_state(host));
    return status;
}
