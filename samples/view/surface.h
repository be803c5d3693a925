// Where a view is drawn: a window, or pixels in memory. Its context is current while it lives.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "samples/contexts/offscreen.h"
#include "samples/view/input.h"

namespace view
{

class Surface
{
public:
    virtual ~Surface() = default;

    using GetProcAddress = contexts::GlFunction (*)(void *user, const char *name);
    virtual GetProcAddress get_proc_address() const = 0;
    virtual void *user() const = 0;
    virtual const std::string &name() const = 0;
    virtual bool flushes_cheaply() const { return true; }  // contexts::Offscreen

    // A width and height of pixels from the left side, `below` lines up: three bytes a pixel, top row first.
    virtual void read(int below, int width, int height, std::vector<uint8_t> &out) = 0;
    virtual void show() {}
    // Another context in place of the present one, which is lost. Throws scenes::Failure.
    virtual void renew() = 0;
};

// Throws scenes::Failure. Pictures may be smaller than this, but not larger.
std::unique_ptr<Surface> make_offscreen_surface(contexts::Kind kind, int width, int height);

class Window : public Surface
{
public:
    // Replaces `input` by what happened since the last call. Returns false when the window was closed.
    virtual bool next(Input &input) = 0;
};

// Throws scenes::Failure, with the system's reason.
std::unique_ptr<Window> open_window(const std::string &title, int width, int height);

}  // namespace view
