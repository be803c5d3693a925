#include "tests/gl/support/mess.h"

namespace gltest
{

void Mess::with_what_claque_sets()
{
    leave_stacks_deep();
    spoil_the_bound_texture();
    kept_.push_back(std::make_unique<HostileHost>(host_));
    spoil_the_bound_texture();
}

void Mess::leave_stacks_deep() const
{
    host_.PushAttrib(gl::enable_bit);
    host_.PushAttrib(gl::all_attrib_bits);
    host_.PushClientAttrib(gl::all_client_attrib_bits);
    for (const gl::Enum stack : {gl::modelview, gl::texture}) {
        host_.MatrixMode(stack);
        host_.PushMatrix();
        host_.PushMatrix();
    }
}

// If it is one of claque's, no later picture is right.
void Mess::spoil_the_bound_texture() const
{
    const std::vector<uint8_t> texels(4096, 77);                          // unpacking may be set to skip many
    host_.TexParameteri(gl::texture_2d, gl::texture_min_filter, 0x2601);  // GL_LINEAR
    host_.TexParameteri(gl::texture_2d, gl::texture_mag_filter, 0x2601);
    host_.TexImage2D(gl::texture_2d, 0, int32_t(gl::rgba8), 1, 1, 0, gl::rgba, gl::unsigned_byte, texels.data());
}

void Mess::with_everything()
{
    with_what_claque_sets();
    constexpr gl::Enum switches[] = {0x0B60, 0x0B50, 0x4000, 0x4003, 0x3000, 0x3005, 0x0B90, 0x0C11, 0x0DE0,
                                     0x8037, 0x2A02, 0x0BF1, 0x0D80, 0x0D97, 0x0DB7, 0x0BD0, 0x809E, 0x803A};
    for (const gl::Enum what : switches) host_.Enable(what);
    const double plane[4] = {0.3, 0.2, 0.1, 0.05};
    host_.ask<void (*)(gl::Enum, const double *)>("glClipPlane")(0x3000, plane);
    const float odd[4] = {0.7f, 0.1f, 0.4f, 1};
    host_.Fogfv(0x0B66, odd);
    host_.Lightfv(0x4000, 0x1201, odd);
    host_.LightModelfv(0x0B53, odd);
    host_.Materialfv(gl::front_and_back, 0x1600, odd);
    host_.ShadeModel(0x1D00);                                                            // GL_FLAT
    host_.PolygonMode(gl::front_and_back, 0x1B01);                                       // GL_LINE
    host_.ask<void (*)(gl::Enum, int32_t, uint32_t)>("glStencilFunc")(0x0200, 1, 0xff);  // GL_NEVER
    host_.ask<void (*)(int32_t, int32_t, int32_t, int32_t)>("glScissor")(3, 4, 50, 60);
    host_.ask<void (*)(double, double)>("glDepthRange")(0.9, 0.3);
    host_.Viewport(7, 9, 33, 44);
    host_.ColorMask(0, 1, 0, 1);
    host_.ClearColor(1, 0, 1, 0);
    host_.ask<void (*)(uint32_t)>("glListBase")(5);
    host_.ask<void (*)(float, float)>("glPixelZoom")(2, 3);
    host_.ask<void (*)(gl::Enum)>("glDrawBuffer")(0);  // GL_NONE
    host_.ask<void (*)(gl::Enum)>("glReadBuffer")(0x0404);
    for (const char *function : {"glActiveTexture", "glClientActiveTexture"})
        if (const auto choose = host_.ask<void (*)(gl::Enum)>(function)) choose(0x84C0);
}

}  // namespace gltest
