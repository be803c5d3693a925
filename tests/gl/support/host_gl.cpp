#include "tests/gl/support/host_gl.h"

#include <stdexcept>

namespace gltest
{

HostGl::HostGl(const contexts::Offscreen &context) : get_(context.get_proc_address()), user_(context.user())
{
    const claque::base::Status status = claque::passes::load(*this, get_, user_);
    if (!status.ok()) throw std::runtime_error(status.text);
    const auto want = [&](auto &slot, const char *name) { slot = ask<std::decay_t<decltype(slot)>>(name); };
    want(Clear, "glClear");
    want(ClearColor, "glClearColor");
    want(Viewport, "glViewport");
    want(GetError, "glGetError");
    want(Finish, "glFinish");
    want(Color4ub, "glColor4ub");
    want(Lightfv, "glLightfv");
    want(LightModelfv, "glLightModelfv");
    want(Materialfv, "glMaterialfv");
    want(Fogfv, "glFogfv");
    want(Fogi, "glFogi");
    want(TexGeni, "glTexGeni");
    want(BlendFunc, "glBlendFunc");
    want(LogicOp, "glLogicOp");
    want(PolygonMode, "glPolygonMode");
    want(NewList, "glNewList");
    want(SelectBuffer, "glSelectBuffer");
    want(IsTexture, "glIsTexture");
}

void HostGl::clear(float r, float g, float b) const
{
    constexpr gl::Bits colour_and_depth = 0x4100;
    PushAttrib(gl::colour_buffer_bit | gl::depth_buffer_bit);
    ColorMask(1, 1, 1, 1);
    DepthMask(1);
    ClearColor(r, g, b, 1);
    Clear(colour_and_depth);
    PopAttrib();
}

}  // namespace gltest
