// A framebuffer object with several samples a pixel, as the target of a context; private to this folder. Mesa's own
// pixel buffers with samples have no colours to draw into since Mesa 25, and no kind but EGL has them.
#pragma once

#include "samples/contexts/backends.h"

namespace contexts
{

// Makes the object and binds it for the life of the context, which is current. False if GL has none with exactly so
// many samples.
bool bind_samples(const Offscreen &context, int samples);

// For reading: binds another object with the mean of each pixel's samples, and the depth of one; and back.
class Resolved
{
public:
    explicit Resolved(const Offscreen &context);
    ~Resolved();

private:
    const Offscreen &context_;
    unsigned drawn_ = 0, object_ = 0, buffers_[2] = {0, 0};
};

}  // namespace contexts
