#include "samples/contexts/samples.h"

namespace contexts
{
namespace
{

constexpr unsigned framebuffer = 0x8D40, draw_framebuffer = 0x8CA9, renderbuffer = 0x8D41, complete = 0x8CD5;
constexpr unsigned framebuffer_binding = 0x8CA6, samples_of_target = 0x80A9;
constexpr unsigned colour = 0x8CE0, depth_and_stencil = 0x821A;  // where buffers are attached
constexpr unsigned rgba8 = 0x8058, depth24_stencil8 = 0x88F0;
constexpr unsigned colour_and_depth_bits = 0x4100, nearest = 0x2600;

using Names = void (*)(int count, unsigned *names);

// Colours, then depth and stencil, attached to the object that is bound to draw into.
void attach_buffers(const Offscreen &context, int samples, unsigned (&buffers)[2])
{
    ask<Names>(context, "glGenRenderbuffers")(2, buffers);
    for (const int i : {0, 1}) {
        ask<void (*)(unsigned, unsigned)>(context, "glBindRenderbuffer")(renderbuffer, buffers[i]);
        ask<void (*)(unsigned, int, unsigned, int, int)>(context, "glRenderbufferStorageMultisample")(
            renderbuffer, samples, i == 0 ? rgba8 : depth24_stencil8, context.width(), context.height());
        ask<void (*)(unsigned, unsigned, unsigned, unsigned)>(context, "glFramebufferRenderbuffer")(
            draw_framebuffer, i == 0 ? colour : depth_and_stencil, renderbuffer, buffers[i]);
    }
}

void bind(const Offscreen &context, unsigned target, unsigned object)
{
    ask<void (*)(unsigned, unsigned)>(context, "glBindFramebuffer")(target, object);
}

unsigned value_of(const Offscreen &context, unsigned name)
{
    int value = 0;
    ask<void (*)(unsigned, int *)>(context, "glGetIntegerv")(name, &value);
    return static_cast<unsigned>(value);
}

}  // namespace

bool bind_samples(const Offscreen &context, int samples)
{
    if (!ask<void (*)()>(context, "glRenderbufferStorageMultisample")) return false;
    unsigned object = 0, buffers[2] = {0, 0};
    ask<Names>(context, "glGenFramebuffers")(1, &object);
    bind(context, framebuffer, object);
    attach_buffers(context, samples, buffers);
    return ask<unsigned (*)(unsigned)>(context, "glCheckFramebufferStatus")(framebuffer) == complete &&
           value_of(context, samples_of_target) == static_cast<unsigned>(samples);
}

Resolved::Resolved(const Offscreen &context) : context_(context), drawn_(value_of(context, framebuffer_binding))
{
    ask<Names>(context, "glGenFramebuffers")(1, &object_);
    bind(context, draw_framebuffer, object_);
    attach_buffers(context, 0, buffers_);
    const int w = context.width(), h = context.height();
    ask<void (*)(int, int, int, int, int, int, int, int, unsigned, unsigned)>(context, "glBlitFramebuffer")(
        0, 0, w, h, 0, 0, w, h, colour_and_depth_bits, nearest);
    bind(context, framebuffer, object_);
}

Resolved::~Resolved()
{
    bind(context_, framebuffer, drawn_);
    ask<Names>(context_, "glDeleteFramebuffers")(1, &object_);
    ask<Names>(context_, "glDeleteRenderbuffers")(2, buffers_);
}

}  // namespace contexts
