// Offscreen OpenGL contexts for samples and tests: OSMesa, EGL without a window system, or GLX. Nothing is linked; the
// libraries are opened at run time, so that one program serves machines that have any. This is no part of libclaque.
//
// One context is current per thread. OSMesa and EGL contexts may live in one process (they share Mesa's dispatch):
// call make_current() before each use when there are several.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace contexts
{

// any: the kind that CLAQUE_CONTEXT names in the environment (any, osmesa, egl, glx); without it OSMesa if it is there,
// else EGL. EGL draws on Mesa's surfaceless platform, else on the first device; CLAQUE_EGL_DEVICE names another by
// number. GLX needs the X server that DISPLAY names, and is only used where it is named.
enum class Kind : uint8_t { any, osmesa, egl, glx };
enum class PixelFormat : uint8_t { rgba8888, rgb565 };

using GlFunction = void (*)();

class Offscreen
{
public:
    virtual ~Offscreen() = default;
    Offscreen(const Offscreen &) = delete;
    Offscreen &operator=(const Offscreen &) = delete;

    virtual bool make_current() = 0;
    virtual bool release() = 0;  // no context is current on this thread afterwards

    // In the form of clq_renderer_def: a C function and its argument. Valid for the life of the process.
    using GetProcAddress = GlFunction (*)(void *user, const char *name);
    virtual GetProcAddress get_proc_address() const = 0;
    virtual void *user() const = 0;

    // For example "OSMesa, llvmpipe (LLVM 15.0.6, 256 bits), 4.5 (Compatibility Profile) Mesa 22.3.6".
    const std::string &name() const { return name_; }
    // False where a flush copies the picture, as with OSMesa; elsewhere it lets GL paint while more is sent.
    virtual bool flushes_cheaply() const = 0;
    int width() const { return width_; }
    int height() const { return height_; }

    // Waits for GL, then reads: three bytes, or one float in [0, 1], a pixel, top row first. The context must be
    // current. Pixel store and transfer state are saved and restored.
    void read_rgb(std::vector<uint8_t> &out) const;
    // The same of the columns [x0, x1).
    void read_rgb(int x0, int x1, std::vector<uint8_t> &out) const;
    void read_depth(std::vector<float> &out) const;

protected:
    Offscreen(int width, int height) : width_(width), height_(height) {}
    bool describe(const char *kind, std::string &why_not);  // fills name_, checks that GL answers

private:
    void read(int x0, int x1, unsigned format, unsigned type, size_t pixel_bytes, void *out) const;

    friend std::unique_ptr<Offscreen> make_offscreen(Kind kind, int width, int height, PixelFormat format,
                                                     std::string &why_not, int samples);

    int width_, height_, samples_ = 1;
    std::string name_;
};

// A word of `Kind`, or nothing.
std::optional<Kind> kind_named(const std::string &word);

// What CLAQUE_CONTEXT names; `any` if it is not set or empty, or another word, which make_offscreen refuses.
Kind kind_of_environment();

// Makes a context of width x height pixels (1 to 16384 each) with 24 bits of depth and 8 of stencil, and makes it
// current. Null, and one sentence in why_not, if this machine cannot.
// `samples` a pixel, 1 or more; several in rgba8888 alone, in a framebuffer object that stays bound.
std::unique_ptr<Offscreen> make_offscreen(Kind kind, int width, int height, PixelFormat format, std::string &why_not,
                                          int samples = 1);

}  // namespace contexts
