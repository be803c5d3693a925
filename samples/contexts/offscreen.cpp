#include "samples/contexts/offscreen.h"

#include <algorithm>
#include <cstdlib>
#include <dlfcn.h>
#include <iterator>

#include "samples/contexts/samples.h"

namespace contexts
{
namespace
{

constexpr int largest_side_px = 16384;  // OSMesa accepts larger ones and draws them wrong

constexpr unsigned gl_renderer = 0x1F01, gl_version = 0x1F02, gl_max_viewport_dims = 0x0D3A;
constexpr unsigned gl_pixel_mode_bit = 0x20, gl_client_pixel_store_bit = 1;
constexpr unsigned gl_pack_first = 0x0D00, gl_pack_alignment = 0x0D05;  // swap, lsb first, row length, two skips
constexpr unsigned gl_map_color = 0x0D10, gl_red_scale = 0x0D14, gl_depth_bias = 0x0D1F;
constexpr unsigned gl_zoom_x = 0x0D16, gl_zoom_y = 0x0D17;
constexpr unsigned gl_rgb = 0x1907, gl_depth_component = 0x1902, gl_unsigned_byte = 0x1401, gl_float = 0x1406;

// Sets all state that glReadPixels uses to its default.
void default_pixel_state(const Offscreen &context)
{
    const auto store = ask<void (*)(unsigned, int)>(context, "glPixelStorei");
    const auto transfer = ask<void (*)(unsigned, float)>(context, "glPixelTransferf");
    for (unsigned name = gl_pack_first; name < gl_pack_alignment; ++name) store(name, 0);
    store(gl_pack_alignment, 1);
    transfer(gl_map_color, 0);
    for (unsigned name = gl_red_scale; name <= gl_depth_bias; ++name)
        // the enums of scales are even
        if (name != gl_zoom_x && name != gl_zoom_y) transfer(name, name % 2 == 0 ? 1.0f : 0.0f);
}

}  // namespace

bool Offscreen::describe(const char *kind, std::string &why_not)
{
    const auto get_string = ask<const unsigned char *(*)(unsigned)>(*this, "glGetString");
    const auto get_integers = ask<void (*)(unsigned, int *)>(*this, "glGetIntegerv");
    const unsigned char *renderer = get_string ? get_string(gl_renderer) : nullptr;
    const unsigned char *version = get_string ? get_string(gl_version) : nullptr;
    if (!renderer || !version || !get_integers) {
        why_not = std::string(kind) + ": GL does not answer after its context was made current";
        return false;
    }
    int most[2] = {0, 0};
    get_integers(gl_max_viewport_dims, most);
    if (width_ > most[0] || height_ > most[1]) {
        why_not = std::string(kind) + ": " + std::to_string(width_) + " x " + std::to_string(height_) +
                  " pixels are more than its " + std::to_string(most[0]) + " x " + std::to_string(most[1]);
        return false;
    }
    name_ = std::string(kind) + ", " + reinterpret_cast<const char *>(renderer) + ", " +
            reinterpret_cast<const char *>(version);
    return true;
}

void Offscreen::read(int x0, int x1, unsigned format, unsigned type, size_t pixel_bytes, void *out) const
{
    ask<void (*)()>(*this, "glFinish")();
    std::optional<Resolved> resolved;
    if (samples_ > 1) resolved.emplace(*this);
    ask<void (*)(unsigned)>(*this, "glPushClientAttrib")(gl_client_pixel_store_bit);
    ask<void (*)(unsigned)>(*this, "glPushAttrib")(gl_pixel_mode_bit);
    default_pixel_state(*this);
    ask<void (*)(int, int, int, int, unsigned, unsigned, void *)>(*this, "glReadPixels")(x0, 0, x1 - x0, height_,
                                                                                         format, type, out);
    ask<void (*)()>(*this, "glPopAttrib")();
    ask<void (*)()>(*this, "glPopClientAttrib")();
    resolved.reset();

    const size_t row_bytes = pixel_bytes * static_cast<size_t>(x1 - x0);
    char *rows = static_cast<char *>(out);
    for (int top = 0, bottom = height_ - 1; top < bottom; ++top, --bottom)
        std::swap_ranges(rows + static_cast<size_t>(top) * row_bytes, rows + static_cast<size_t>(top + 1) * row_bytes,
                         rows + static_cast<size_t>(bottom) * row_bytes);
}

void Offscreen::read_rgb(std::vector<uint8_t> &out) const { read_rgb(0, width_, out); }

void Offscreen::read_rgb(int x0, int x1, std::vector<uint8_t> &out) const
{
    out.resize(3 * static_cast<size_t>(x1 - x0) * static_cast<size_t>(height_));
    read(x0, x1, gl_rgb, gl_unsigned_byte, 3, out.data());
}

void Offscreen::read_depth(std::vector<float> &out) const
{
    out.resize(static_cast<size_t>(width_) * static_cast<size_t>(height_));
    read(0, width_, gl_depth_component, gl_float, sizeof(float), out.data());
}

std::optional<Kind> kind_named(const std::string &word)
{
    constexpr const char *words[] = {"any", "osmesa", "egl", "glx"};  // as Kind lists them
    for (size_t kind = 0; kind < std::size(words); ++kind)
        if (word == words[kind]) return static_cast<Kind>(kind);
    return std::nullopt;
}

Kind kind_of_environment() { return kind_named(environment("CLAQUE_CONTEXT")).value_or(Kind::any); }

namespace
{

// With one sample a pixel.
std::unique_ptr<Offscreen> make_one(Kind kind, int width, int height, PixelFormat format, std::string &why_not)
{
    if (kind == Kind::glx) return make_glx(width, height, format, why_not);
    std::unique_ptr<Offscreen> made;
    std::string osmesa_why, egl_why;
    if (kind != Kind::egl) made = make_osmesa(width, height, format, osmesa_why);
    if (!made && kind != Kind::osmesa) made = make_egl(width, height, format, egl_why);
    if (!made) why_not = osmesa_why + (osmesa_why.empty() || egl_why.empty() ? "" : ", and ") + egl_why;
    return made;
}

}  // namespace

std::unique_ptr<Offscreen> make_offscreen(Kind kind, int width, int height, PixelFormat format, std::string &why_not,
                                          int samples)
{
    if (width < 1 || height < 1 || width > largest_side_px || height > largest_side_px) {
        why_not = "a picture of " + std::to_string(width) + " x " + std::to_string(height) +
                  " pixels; each side must be 1 to " + std::to_string(largest_side_px);
        return nullptr;
    }
    tell_leak_checker();
    const std::string word = environment("CLAQUE_CONTEXT");
    if (!word.empty() && !kind_named(word)) {
        why_not = "CLAQUE_CONTEXT is '" + word + "'; it can be osmesa, egl, glx or any";
        return nullptr;
    }
    if (kind == Kind::any) kind = kind_of_environment();
    if (samples > 1 && format != PixelFormat::rgba8888) {
        why_not = "contexts with several samples a pixel have the format rgba8888";
        return nullptr;
    }
    std::unique_ptr<Offscreen> made = make_one(kind, width, height, format, why_not);
    if (!made || samples == 1) return made;
    if (!bind_samples(*made, samples)) {
        why_not = made->name() + ": no target with " + std::to_string(samples) + " samples a pixel";
        return nullptr;
    }
    made->samples_ = samples;
    return made;
}

std::string environment(const char *name)
{
    const char *value = std::getenv(name);
    return value ? value : "";
}

void *open_library(const char *const *names)
{
    for (; *names; ++names)
        if (void *library = dlopen(*names, RTLD_NOW | RTLD_LOCAL)) return library;
    return nullptr;
}

void *find_symbol(void *library, const char *name) { return dlsym(library, name); }

}  // namespace contexts
